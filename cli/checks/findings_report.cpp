#include "cli/checks/findings_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/enumeration.h"
#include "base/number.h"
#include "base/utf8.h"
#include "rainfall/network/network_dual.h"
#include "readings/units/rain_unit.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t longest_id = 40;
constexpr std::size_t longest_time = 40;
constexpr std::size_t told_of_each = 3;
constexpr int digits = 6;

GaugeNeighbours neighbours_of(const Inputs& inputs, std::size_t threads) {
  const bool are_few = inputs.network().stations().size() < ReadingSearches::least_gauges;
  if (are_few) return {inputs.network(), {}};
  const NetworkDual dual =
      network_dual(inputs.network(), inputs.all_report(), inputs.weighing().yardstick(),
                   static_cast<unsigned>(threads));
  return {inputs.network(), dual.borders};
}

/// What readings in a unit stand for; where it is not known they count as millimetres.
AmountMeaning meaning_of(const std::string& name) {
  const std::optional<RainUnit> unit = rain_unit(name);
  if (!unit) return {};
  return {static_cast<double>(unit->multiply) / static_cast<double>(unit->divide),
          time_of_rate(*unit)};
}

std::string number(double value) {
  if (!std::isfinite(value)) return "inf";
  return shortest_text(parse_number(significant_text(value, digits)).value);
}

}  // namespace

FindingsReport::FindingsReport(const Inputs& inputs, const std::string& unit, std::size_t threads,
                               OutputFile* file)
    : inputs_(inputs),
      unit_(unit),
      neighbours_(neighbours_of(inputs, threads)),
      searches_(neighbours_, meaning_of(unit)) {
  if (file != nullptr) file_.emplace(*file, inputs.network());
}

std::string FindingsReport::told(const ReadingFinding& finding) const {
  std::string text =
      quoted(inputs_.network().stations()[index(finding.station)].id, longest_id) + " ";
  switch (finding.kind) {
    case FindingKind::unit:
      return text + "(" + number(finding.value) + " times its neighbours)";
    case FindingKind::shift:
      return text + (finding.value > 0 ? "(a step late)" : "(a step early)");
    case FindingKind::jump:
      return text + "(" + number(finding.value) + " times what it was, from " +
             std::to_string(finding.since) + " on)";
    case FindingKind::spike:
    case FindingKind::zero:
    case FindingKind::stuck:
      break;
  }
  text += "at " + printable(finding.time.substr(0, longest_time)) + " (" + number(finding.value);
  if (!std::isnan(finding.expected)) text += ", neighbours " + number(finding.expected);
  return text + ")";
}

void FindingsReport::take(const ReadingFinding& finding) {
  if (file_) file_->add(finding);
  OfKind& kind = kinds_.at(static_cast<std::size_t>(finding.kind));
  if (kind.first.size() < told_of_each) kind.first.push_back(told(finding));
  ++kind.count;
}

/// Which kinds are not looked for, and why; kinds of one reason together.
std::string FindingsReport::left_out() const {
  std::vector<std::pair<std::string, std::string>> kinds;  // by reason
  for (const FindingKind kind : all_findings) {
    const std::string reason = searches_.reason_against(kind);
    if (reason.empty()) continue;
    const auto same = std::find_if(kinds.begin(), kinds.end(),
                                   [&](const auto& one) { return one.first == reason; });
    if (same == kinds.end()) {
      kinds.emplace_back(reason, name_of(kind));
    } else {
      same->second += std::string(", ") + name_of(kind);
    }
  }
  std::string text;
  for (const auto& [reason, names] : kinds)
    text += (text.empty() ? "" : "; ") + names + " (" + reason + ")";
  return text;
}

/// The kinds that are looked for and of which there is none.
std::string FindingsReport::found_none_of() const {
  std::string text;
  for (const FindingKind kind : all_findings) {
    if (!of_kind(kind).count && searches_.is_sought(kind))
      text += std::string(text.empty() ? "" : ", ") + name_of(kind);
  }
  return text;
}

/// A line for each kind that is found, with the first of it.
std::string FindingsReport::lines() const {
  std::string text;
  for (const FindingKind kind : all_findings) {
    const OfKind& found = of_kind(kind);
    if (found.count == 0) continue;
    text += std::string("  ") + name_of(kind) + ": " + std::to_string(found.count) + ": " +
            enumerated(found.first, found.count) + "\n";
  }
  return text;
}

/// Says what the bounds are taken to be in where nothing tells the unit of the readings.
std::string FindingsReport::about_unit() const {
  const bool has_bounds =
      searches_.is_sought(FindingKind::zero) || searches_.is_sought(FindingKind::spike);
  return has_bounds && !rain_unit(unit_) ? " (bounds in mm, for nothing says the unit)" : "";
}

std::string FindingsReport::text() {
  searches_.conclude([&](const ReadingFinding& finding) { take(finding); });
  std::size_t all = 0;
  for (const OfKind& kind : kinds_) all += kind.count;
  const std::string none = found_none_of();
  const std::string left = left_out();
  std::string text = "readings that cannot be true" + about_unit() + ": ";
  if (all > 0) text += std::to_string(all) + "\n" + lines() + "  ";
  if (!none.empty()) text += "none of " + none;
  if (!none.empty() && !left.empty()) text += "; ";
  if (!left.empty()) text += "not looked for: " + left;
  if (all > 0 && none.empty() && left.empty()) text.resize(text.size() - 3);
  return text + "\n";
}

}  // namespace thiessen::cli
