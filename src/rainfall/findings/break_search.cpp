#include "rainfall/findings/break_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "rainfall/findings/homogeneity.h"
#include "rainfall/findings/neighbour_readings.h"

namespace thiessen {
namespace {

/// Beside a neighbour whose ratio is always the same all others would count for nothing.
constexpr double least_squares = 1e-6;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

/// What a gauge and one neighbour read together, by year; NaN where the year does not count.
struct BreakSearch::Yearly {
  std::vector<double> own;
  std::vector<double> other;
  std::vector<double> ratios;  ///< logarithms, less their mean
  double weight = 0;           ///< one over the variance of these

  std::size_t years() const {
    return static_cast<std::size_t>(std::count_if(ratios.begin(), ratios.end(),
                                                  [](double ratio) { return !std::isnan(ratio); }));
  }
  /// How many times its slope before is that of the double mass curve from year `at` on.
  double change(std::size_t at) const {
    double sums[2][2] = {};
    for (std::size_t y = 0; y < own.size(); ++y) {
      if (std::isnan(ratios[y])) continue;
      sums[y < at ? 0 : 1][0] += own[y];
      sums[y < at ? 0 : 1][1] += other[y];
    }
    return sums[1][0] / sums[1][1] / (sums[0][0] / sums[0][1]);
  }
};

BreakSearch::Yearly BreakSearch::yearly(const GaugeNeighbours::Neighbour& neighbour) const {
  Yearly found;
  std::uint32_t fullest = 0;
  for (const auto& [year, totals] : totals_.years())
    fullest = std::max(fullest, totals[neighbour.pair].steps);
  double sum = 0;
  for (const auto& [year, totals] : totals_.years()) {
    const NeighbourTotals::Totals& both = totals[neighbour.pair];
    double own = static_cast<double>(both.first);
    double other = static_cast<double>(both.second);
    if (neighbour.is_second) std::swap(own, other);
    const bool counts = 2 * both.steps >= fullest && own > 0 && other > 0;
    found.own.push_back(own);
    found.other.push_back(other);
    found.ratios.push_back(counts ? std::log(own / other) : unknown);
    sum += counts ? found.ratios.back() : 0;
  }
  const double mean = sum / static_cast<double>(found.years());
  double squares = 0;
  for (double& ratio : found.ratios) {
    ratio -= mean;
    squares += std::isnan(ratio) ? 0 : ratio * ratio;
  }
  found.weight = static_cast<double>(found.years()) / std::max(squares, least_squares);
  return found;
}

std::optional<ReadingFinding> BreakSearch::break_of(StationIndex gauge) const {
  std::vector<Yearly> neighbours;
  for (const GaugeNeighbours::Neighbour& neighbour : totals_.neighbours().of(gauge)) {
    Yearly found = yearly(neighbour);
    if (found.years() >= least_years) neighbours.push_back(std::move(found));
  }
  if (neighbours.size() < least_neighbours) return std::nullopt;
  std::vector<double> series;
  std::vector<std::size_t> years;  // of the series, as positions among all years
  std::vector<int> names;
  for (const auto& [year, totals] : totals_.years()) names.push_back(year);
  for (std::size_t y = 0; y < names.size(); ++y) {
    double sum = 0;
    double weights = 0;
    std::size_t telling = 0;
    for (const Yearly& neighbour : neighbours) {
      if (std::isnan(neighbour.ratios[y])) continue;
      ++telling;
      sum += neighbour.weight * neighbour.ratios[y];
      weights += neighbour.weight;
    }
    if (telling < least_neighbours) continue;
    series.push_back(sum / weights);
    years.push_back(y);
  }
  if (series.size() < least_years) return std::nullopt;
  const MeanChange change = mean_change(series, least_years_on_a_side);
  if (!(change.statistic > least_statistic)) return std::nullopt;
  const std::size_t at = years[change.at];
  std::vector<double> changes;
  for (const Yearly& neighbour : neighbours) {
    const double ratio = neighbour.change(at);
    if (!std::isnan(ratio)) changes.push_back(ratio);
  }
  const double ratio = median_of(changes);
  if (!(ratio > least_ratio) && !(ratio < 1 / least_ratio)) return std::nullopt;
  return ReadingFinding{gauge, FindingKind::jump, "", ratio, 1, names[at]};
}

void BreakSearch::conclude(const TakeFinding& take) {
  for (std::uint32_t g = 0; g < totals_.neighbours().gauges(); ++g) {
    if (const auto found = break_of(StationIndex{g})) take(*found);
  }
}

}  // namespace thiessen
