#include "rainfall/mean_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "base/parallel.h"
#include "rainfall/rainfall_error.h"

namespace thiessen {
namespace {

constexpr std::size_t near_ones = 6;
constexpr std::size_t weighed_steps = 100;

}  // namespace

MeanError::MeanError(const ArealRainfall& rainfall, const Weighing& weighing)
    : rainfall_(rainfall),
      weighing_(weighing),
      sites_(weighing.network().places(), weighing.ground().metric),
      sample_(weighing.network().stations().size(),
              steps_for_errors(weighing.network().stations().size())) {
  add_pairs();
}

void MeanError::add_pairs() {
  const auto near = sites_.nearest_others(near_ones);
  for (std::uint32_t a = 0; a < near.size(); ++a) {
    for (const std::uint32_t b : near[a]) {
      const bool from_b = std::find(near[b].begin(), near[b].end(), a) != near[b].end();
      if (a < b || !from_b) pairs_.push_back({a, b});
    }
  }
}

void MeanError::add(std::span<const double> readings) {
  sample_.add(readings);
  ++steps_;
  const std::vector<double> of_cell = rainfall_.cell_readings(readings);
  std::vector<double> of_site(of_cell.size());
  for (std::uint32_t site = 0; site < of_site.size(); ++site)
    of_site[site] = of_cell[sites_.place_of(site)];
  for (Pair& pair : pairs_) {
    const double difference = of_site[pair.b] - of_site[pair.a];
    if (std::isnan(difference)) continue;
    pair.sum += difference;
    pair.squares += difference * difference;
    ++pair.steps;
  }
}

FieldVariance MeanError::variance(const StepVariance& of_field) const {
  std::size_t most = 1;
  for (const Pair& pair : pairs_) most = std::max(most, pair.steps);
  std::vector<SquaredDifference> differences;
  std::unordered_set<std::uint32_t> gauges;
  for (const Pair& pair : pairs_) {
    if (pair.steps < 2 || 2 * pair.steps < most) continue;
    const auto count = static_cast<double>(pair.steps);
    const double mean = pair.sum / count;
    const double scatter = (pair.squares - pair.sum * mean) / (count - 1);
    const double lost = scatter * (1 / count - 1 / static_cast<double>(steps_));
    differences.push_back({pair.a, pair.b, mean * mean - lost});
    gauges.insert({pair.a, pair.b});
  }
  return of_field.of(differences, gauges.size());
}

std::vector<double> MeanError::result(unsigned threads) const {
  std::vector<double> errors(weighing_.basins().size(), std::numeric_limits<double>::quiet_NaN());
  const RainfallError error(rainfall_, weighing_, sample_, threads);
  if (!error.shortfall().empty()) return errors;
  const FieldVariance field = variance(error.variance());
  if (std::isnan(field.variance)) return errors;
  const std::size_t steps = std::min(sample_.steps(), weighed_steps);
  std::vector<std::vector<double>> squares(steps);
  in_parallel(steps, threads, [&](std::size_t, std::size_t i) {
    squares[i] = error.mean_squares_at(sample_[i * sample_.steps() / steps]);
  });
  for (std::size_t b = 0; b < errors.size(); ++b) {
    double sum = 0;
    double count = 0;
    for (const auto& at_step : squares) {
      if (std::isnan(at_step[b])) continue;
      sum += at_step[b];
      ++count;
    }
    if (count > 0)
      errors[b] = StepVariance::widening(field.degrees) * std::sqrt(field.variance * sum / count);
  }
  return errors;
}

}  // namespace thiessen
