#include "cli/outputs/summary.h"

#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "cli/outputs/text_table.h"
#include "rainfall/influence/search_budget.h"

namespace thiessen::cli {
namespace {

// The sample of steps in which the most influential gauge is looked for is bounded, and so is the
// share that the search adds to the work of the run.
constexpr std::size_t sample_bytes = std::size_t{32} << 20;
constexpr std::size_t sampled_steps = 4096;
constexpr double share_of_search = 0.1;

}  // namespace

Summary::Summary(const Inputs& inputs, const std::vector<BasinWeights>& weights)
    : inputs_(inputs),
      weights_(weights),
      findings_(findings_of(inputs.whole(), weights)),
      statistics_(weights.size()),
      sample_(inputs.network().stations().size(),
              steps_within(sample_bytes, inputs.network().stations().size(), sampled_steps)) {}

void Summary::add(const RainStep& step) {
  statistics_.add(step.basins);
  sample_.add(step.readings);
}

void Summary::find_most_influential(const ArealRainfall& rainfall, unsigned threads) {
  const SearchWork work = search_work(rainfall.handovers(), sample_, statistics_.steps());
  influence_ = thiessen::most_influential(rainfall.handovers(), sample_,
                                          spacing_within(work, share_of_search), threads);
}

std::string Summary::most_influential(std::size_t basin, const std::string& unit) const {
  if (basin >= influence_.gauges.size() || !(influence_.gauges[basin].rms_change > 0)) return "-";
  const MostInfluential& gauge = influence_.gauges[basin];
  return printable(inputs_.network().stations()[index(gauge.station)].id) + " (" +
         fixed_text(gauge.rms_change, 2) + unit + ")";
}

std::string Summary::text(const std::string& units) const {
  const std::string unit = units.empty() ? "" : " " + printable(units);
  std::vector<std::vector<std::string>> rows;
  rows.push_back({"basin", inputs_.area_unit().known() ? "area km2" : "area", "gauges inside",
                  "weighing", "largest weight", "mean" + unit, "standard error" + unit,
                  "largest" + unit, "empty steps", "most influential gauge"});
  for (std::size_t b = 0; b < weights_.size(); ++b) {
    const RainStatistics::OfBasin& rain = statistics_.basins()[b];
    const bool has_values = rain.values > 0;
    const bool has_error = has_values && b < errors_.size() && !std::isnan(errors_[b]);
    rows.push_back({printable(inputs_.basins()[b].id),
                    fixed_text(weights_[b].area * inputs_.area_unit().km2, 2),
                    std::to_string(findings_.basins[b].gauges_inside),
                    std::to_string(weights_[b].stations.size()),
                    fixed_text(findings_.basins[b].largest_weight, 3),
                    has_values ? fixed_text(rain.mean(), 2) : "-",
                    has_error ? fixed_text(errors_[b], 2) : "-",
                    has_values ? fixed_text(rain.largest, 2) : "-", std::to_string(rain.empty),
                    most_influential(b, unit)});
  }
  std::string text = aligned(rows);
  if (!shortfall_.empty()) text += "No standard errors: " + shortfall_ + ".\n";
  if (influence_.gauges.empty() && statistics_.steps() > 0) {
    text +=
        "The most influential gauges are told with --gaps retessellate and without --min-gauges.\n";
  } else if (influence_.steps < statistics_.steps()) {
    text += "The most influential gauges are those of " + std::to_string(influence_.steps) +
            " of the " + std::to_string(statistics_.steps()) +
            " steps, evenly spaced: looking for them may take a tenth of a run.\n";
  }
  return text;
}

}  // namespace thiessen::cli
