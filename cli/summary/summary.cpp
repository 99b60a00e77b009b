#include "cli/summary/summary.h"

#include <cmath>
#include <cstdint>

#include "base/error.h"
#include "cli/summary/fitted_table.h"
#include "cli/summary/summary_columns.h"
#include "rainfall/influence/search_budget.h"
#include "readings/units/rain_unit.h"

namespace thiessen::cli {
namespace {

// The sample of steps in which the most influential gauge is looked for is bounded, and so is the
// share that the search adds to the work of the run; but what is over in a moment is done whole.
constexpr std::size_t sample_bytes = std::size_t{32} << 20;
constexpr std::size_t sampled_steps = 4096;
constexpr double share_of_search = 0.1;
constexpr double least_search = 250e3;  // microseconds

}  // namespace

Summary::Summary(const Inputs& inputs, const std::vector<BasinWeights>& weights)
    : inputs_(inputs),
      weights_(weights),
      findings_(findings_of(inputs.whole(), weights)),
      statistics_(weights.size()),
      sample_(inputs.network().stations().size(),
              steps_within(sample_bytes, inputs.network().stations().size(), sampled_steps)) {}

void Summary::want_depths(const std::vector<NamedDuration>& lengths, const std::string& file) {
  if (lengths.empty()) return;
  lengths_ = lengths;
  std::vector<std::int64_t> seconds;
  for (const NamedDuration& length : lengths_) seconds.push_back(length.seconds);
  depths_.emplace(std::move(seconds), weights_.size(), file);
}

void Summary::find_depths(const std::string& unit) {
  if (!depths_) return;
  const std::optional<RainUnit> known = rain_unit(unit);
  largest_depths_ = depths_->result(known ? time_of_rate(*known) : std::nullopt);
}

void Summary::add(const RainStep& step, const NormalMonth& month) {
  if (depths_) depths_->add(step);
  statistics_.add(step.basins);
  sample_.add(step.readings, month);
}

void Summary::find_most_influential(const ArealRainfall& rainfall, unsigned threads) {
  const SearchWork work = search_work(rainfall.handovers(), sample_, statistics_.steps());
  influence_ = thiessen::most_influential(
      rainfall.handovers(), sample_, spacing_within(work, share_of_search, least_search), threads);
}

std::vector<BasinSummary> Summary::basins() const {
  std::vector<BasinSummary> summaries;
  for (std::size_t b = 0; b < weights_.size(); ++b) {
    BasinSummary& summary = summaries.emplace_back();
    summary.basin = inputs_.basins()[b].id;
    summary.area = weights_[b].area * inputs_.area_unit().km2;
    summary.gauges_inside = findings_.basins[b].gauges_inside;
    summary.gauges_weighing = weights_[b].stations.size();
    summary.largest_weight = findings_.basins[b].largest_weight;
    const RainStatistics::OfBasin& rain = statistics_.basins()[b];
    summary.empty_steps = rain.empty;
    if (rain.values > 0) {
      summary.mean = rain.mean();
      summary.largest = rain.largest;
      if (b < errors_.size() && !std::isnan(errors_[b])) summary.standard_error = errors_[b];
    }
    for (std::size_t i = 0; i < largest_depths_.size(); ++i) {
      BasinDepth& depth = summary.depths.emplace_back(BasinDepth{lengths_[i].name, {}, ""});
      if (const auto& largest = largest_depths_[i][b]) {
        depth.depth = largest->depth;
        depth.time = largest->time;
      }
    }
    if (b >= influence_.gauges.size() || !(influence_.gauges[b].rms_change > 0)) continue;
    summary.most_influential = inputs_.network().stations()[index(influence_.gauges[b].station)].id;
    summary.influence = influence_.gauges[b].rms_change;
  }
  return summaries;
}

std::string Summary::remarks() const {
  std::string text;
  if (!shortfall_.empty()) text += "No standard errors: " + shortfall_ + ".\n";
  if (influence_.gauges.empty() && statistics_.steps() > 0) {
    text +=
        "The most influential gauges are told with --gaps retessellate and without "
        "--min-gauges.\n";
  } else if (influence_.steps < statistics_.steps()) {
    text += "The most influential gauges are those of " + std::to_string(influence_.steps) +
            " of the " + std::to_string(statistics_.steps()) +
            " steps, evenly spaced: looking for them may take a tenth of a run, or a quarter of a "
            "second.\n";
  }
  return text;
}

std::string Summary::text(const std::string& units, std::size_t width) const {
  const std::vector<BasinSummary> summaries = basins();
  const std::string unit = units.empty() ? "" : " " + printable(units);
  const std::string area = inputs_.area_unit().known() ? "area km2" : "area";
  const std::string depth = units.empty() ? "" : " " + printable(depth_unit(units));
  return fitted(summary_columns(summaries, area, unit, depth), width) + wrapped(remarks(), width);
}

}  // namespace thiessen::cli
