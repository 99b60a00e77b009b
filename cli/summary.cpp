#include "cli/summary.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "basin/containment.h"
#include "cli/text_table.h"

namespace thiessen::cli {
namespace {

// Of the sample in which gauges' influence is looked for.
constexpr std::size_t sample_bytes = std::size_t{32} << 20;
constexpr std::size_t sampled_steps = 4096;
constexpr std::size_t sampled_handovers = 40'000;

}  // namespace

Summary::Summary(const Inputs& inputs, const std::vector<BasinWeights>& weights)
    : inputs_(inputs),
      weights_(weights),
      lines_(weights.size()),
      sample_(inputs.network().stations().size(),
              steps_within(sample_bytes, inputs.network().stations().size(), sampled_steps)) {
  std::vector<Point> positions;
  for (const Station& station : inputs.network().stations()) positions.push_back(station.position);
  const double period = inputs.study().metric == Metric::geodesic ? 360 : 0;
  const auto inside = count_within(inputs.basins(), positions, period);
  for (std::size_t b = 0; b < lines_.size(); ++b) lines_[b].inside = inside[b];
}

void Summary::add(const RainStep& step) {
  ++steps_;
  sample_.add(step.readings);
  for (std::size_t b = 0; b < lines_.size(); ++b) {
    const double value = step.basins[b].rainfall;
    Line& line = lines_[b];
    if (std::isnan(value)) {
      ++line.empty;
      continue;
    }
    line.largest = line.values == 0 ? value : std::max(line.largest, value);
    line.sum += value;
    ++line.values;
  }
}

void Summary::find_most_influential(const ArealRainfall& rainfall, unsigned threads) {
  influence_ =
      thiessen::most_influential(rainfall.handovers(), sample_, sampled_handovers, threads);
}

std::string Summary::most_influential(std::size_t basin, const std::string& unit) const {
  if (basin >= influence_.gauges.size() || !(influence_.gauges[basin].rms_change > 0)) return "-";
  const MostInfluential& gauge = influence_.gauges[basin];
  return printable(inputs_.network().stations()[index(gauge.station)].id) + " (" +
         fixed_text(gauge.rms_change, 2) + unit + ")";
}

std::string Summary::text(const std::string& units) const {
  const std::string unit = units.empty() ? "" : " " + printable(units);
  const bool known = inputs_.area_unit().km2 != 1;
  std::vector<std::vector<std::string>> rows;
  rows.push_back({"basin", known ? "area km2" : "area", "gauges inside", "weighing",
                  "largest weight", "mean" + unit, "standard error" + unit, "largest" + unit,
                  "empty steps", "most influential gauge"});
  for (std::size_t b = 0; b < lines_.size(); ++b) {
    const Line& line = lines_[b];
    double largest_weight = 0;
    for (const StationWeight& s : weights_[b].stations)
      largest_weight = std::max(largest_weight, s.weight);
    const bool has_values = line.values > 0;
    const bool has_error = has_values && b < errors_.size() && !std::isnan(errors_[b]);
    rows.push_back({printable(inputs_.basins()[b].id),
                    fixed_text(weights_[b].area * inputs_.area_unit().km2, 2),
                    std::to_string(line.inside), std::to_string(weights_[b].stations.size()),
                    fixed_text(largest_weight, 3),
                    has_values ? fixed_text(line.sum / static_cast<double>(line.values), 2) : "-",
                    has_error ? fixed_text(errors_[b], 2) : "-",
                    has_values ? fixed_text(line.largest, 2) : "-", std::to_string(line.empty),
                    most_influential(b, unit)});
  }
  std::string text = aligned(rows);
  if (!shortfall_.empty()) text += "No standard errors: " + shortfall_ + ".\n";
  if (influence_.gauges.empty() && steps_ > 0) {
    text +=
        "The most influential gauges are told with --gaps retessellate and without --min-gauges.\n";
  } else if (influence_.steps < steps_) {
    text += "The most influential gauges are those of " + std::to_string(influence_.steps) +
            " of the " + std::to_string(steps_) + " steps, evenly spaced.\n";
  }
  return text;
}

}  // namespace thiessen::cli
