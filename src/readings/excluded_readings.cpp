#include "readings/excluded_readings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_set>
#include <utility>

#include "base/counted.h"
#include "base/interrupt.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

using Standing = ReadingsStations::Standing;

constexpr std::size_t longest_id = 80;

/// What tells a moment from all others, and from texts: no time contains a line end.
std::string moment_key(const IsoTime& time) {
  return "\n" + std::to_string(moment_seconds(time)) + "\n" + std::to_string(time.nanosecond) +
         "\n" + std::to_string(static_cast<int>(time.precision));
}

}  // namespace

Exclusions::Exclusions(const ExclusionList& list, const ReadingsStations& stations,
                       bool ignore_unknown, Warnings& warnings)
    : file_(list.file),
      whole_(stations.all().size(), false),
      partly_(stations.all().size(), false) {
  Complaints unknown;
  std::size_t passed_over = 0;
  std::unordered_set<std::string> elsewhere;  // gauges that are wholly excluded
  for (const ExclusionList::Row& row : list.rows) {
    const ReadingsStations::Found found = stations.find(row.station);
    if (found.standing == Standing::known) {
      add(row, found.station);
    } else if (found.standing == Standing::passed_over) {
      if (trimmed(row.time).empty()) {
        whole_gauges_ += elsewhere.insert(row.station).second ? 1u : 0u;
      } else {
        ++elsewhere_;
      }
    } else if (ignore_unknown) {
      ++passed_over;
    } else {
      unknown.add({file_, row.line,
                   "station " + quoted(row.station, longest_id) + " is not in " + input("stations"),
                   setting("ignore_unknown") + " passes over such rows"});
    }
  }
  unknown.throw_if_any();
  if (passed_over == 0) return;
  warnings.add({file_, 0,
                counted(passed_over, "row") + " of stations that are not in " + input("stations") +
                    (passed_over == 1 ? " is" : " are") + " passed over",
                ""});
}

void Exclusions::add(const ExclusionList::Row& row, StationIndex station) {
  const std::string time(trimmed(row.time));
  if (time.empty()) {
    whole_gauges_ += whole_[station] ? 0u : 1u;
    whole_.set(station, true);
    return;
  }
  const ParsedTime parsed = parse_iso_time(time);
  const auto [at, fresh] = by_time_.try_emplace(time, steps_.size());
  std::size_t step = at->second;
  if (fresh && parsed)
    step = at->second = by_time_.try_emplace(moment_key(parsed.time), step).first->second;
  if (step == steps_.size()) steps_.emplace_back();
  std::vector<StationIndex>& gauges = steps_[step];
  if (std::find(gauges.begin(), gauges.end(), station) != gauges.end()) return;
  gauges.push_back(station);
  partly_.set(station, true);
  ++named_;
}

const std::vector<StationIndex>& Exclusions::at(const TimeStep& step) const {
  static const std::vector<StationIndex> none;
  if (by_time_.empty()) return none;
  auto found = by_time_.find(std::string(trimmed(step.time)));
  if (found == by_time_.end()) {
    const ParsedTime time = calendar_time(step.time, step.written);
    if (time) found = by_time_.find(moment_key(time.time));
  }
  return found == by_time_.end() ? none : steps_[found->second];
}

ExcludedReadings::ExcludedReadings(std::unique_ptr<Readings> all, Exclusions excluded,
                                   Warnings& warnings)
    : all_(std::move(all)), excluded_(std::move(excluded)), warnings_(warnings) {
  for (std::uint32_t g = 0; g < excluded_.whole().size(); ++g) {
    if (excluded_.whole()[StationIndex{g}]) whole_.push_back(StationIndex{g});
  }
}

bool ExcludedReadings::next(TimeStep& step) {
  if (!all_->next(step)) {
    if (!std::exchange(told_, true)) tell();
    return false;
  }
  const std::vector<StationIndex>& at_step = excluded_.at(step);
  if (at_step.empty() && whole_.empty()) return true;
  readings_.assign(step.readings.begin(), step.readings.end());
  for (const StationIndex gauge : at_step) {
    double& reading = readings_[index(gauge)];
    taken_out_ += std::isnan(reading) ? 0u : 1u;
    reading = std::numeric_limits<double>::quiet_NaN();
  }
  for (const StationIndex gauge : whole_)
    readings_[index(gauge)] = std::numeric_limits<double>::quiet_NaN();
  step.readings = readings_;
  return true;
}

void ExcludedReadings::tell() {
  const std::size_t taken_out = taken_out_ + (beneath_ != nullptr ? beneath_->taken_out_ : 0);
  std::string text = counted(taken_out, "reading");
  if (excluded_.whole_gauges() > 0)
    text += " and all of " + counted(excluded_.whole_gauges(), "gauge");
  text +=
      taken_out == 1 && excluded_.whole_gauges() == 0 ? " counts as missing" : " count as missing";
  const std::size_t lacking = excluded_.named() - taken_out;
  if (lacking > 0) text += "; " + std::to_string(lacking) + " more that it names are not there";
  if (excluded_.elsewhere() > 0) {
    text += "; " + counted(excluded_.elsewhere(), "row") +
            (excluded_.elsewhere() == 1 ? " is" : " are") +
            " of stations without a part in the network";
  }
  warnings_.add_notice({excluded_.file(), 0, text, ""});
}

ReportingStations without(const Exclusions& excluded, ReportingStations reports) {
  for (std::uint32_t g = 0; g < reports.size(); ++g) {
    if (excluded.whole()[StationIndex{g}]) reports.set(StationIndex{g}, false);
  }
  return reports;
}

ReportingStations reporting_beside(const Exclusions& excluded, ReportingStations reports,
                                   Readings& readings) {
  reports = without(excluded, std::move(reports));
  std::vector<StationIndex> silent;  // as far as is known
  for (std::uint32_t g = 0; g < reports.size(); ++g) {
    const StationIndex gauge{g};
    if (reports[gauge] && excluded.partly()[gauge]) silent.push_back(gauge);
  }
  for (TimeStep step; !silent.empty() && readings.next(step);) {
    throw_if_interrupted();
    const std::vector<StationIndex>& at_step = excluded.at(step);
    std::erase_if(silent, [&](StationIndex gauge) {
      return !std::isnan(step.readings[index(gauge)]) &&
             std::find(at_step.begin(), at_step.end(), gauge) == at_step.end();
    });
  }
  for (const StationIndex gauge : silent) reports.set(gauge, false);
  return reports;
}

}  // namespace thiessen
