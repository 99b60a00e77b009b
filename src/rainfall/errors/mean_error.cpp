#include "rainfall/errors/mean_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "base/parallel.h"
#include "rainfall/errors/rainfall_error.h"
#include "rainfall/normals/relative_readings.h"

namespace thiessen {
namespace {

constexpr std::size_t near_ones = 6;
constexpr std::size_t weighed_steps = 100;

}  // namespace

MeanError::MeanError(const ArealRainfall& rainfall, const Weighing& weighing)
    : rainfall_(rainfall),
      weighing_(weighing),
      sites_(weighing.network().places(), weighing.yardstick().metric),
      sample_(weighing.network().stations().size(),
              steps_for_errors(weighing.network().stations().size())),
      of_normals_(weighing.basins().size()) {
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

void MeanError::add(std::span<const double> readings, std::span<const BasinRainfall> values,
                    const NormalMonth& month) {
  const std::vector<double> of_field = relative_readings(weighing_.normals(), readings, month);
  sample_.add(of_field);
  ++steps_;
  add_normals(values, month);
  const std::vector<double> of_site = by_site(sites_, rainfall_.cell_readings(of_field));
  for (Pair& pair : pairs_) {
    const double difference = of_site[pair.b] - of_site[pair.a];
    if (std::isnan(difference)) continue;
    pair.sum += difference;
    pair.squares += difference * difference;
    ++pair.steps;
  }
}

void MeanError::add_normals(std::span<const BasinRainfall> values, const NormalMonth& month) {
  if (weighing_.normals() == nullptr) return;
  for (std::size_t b = 0; b < values.size(); ++b) {
    if (std::isnan(values[b].rainfall)) continue;
    of_normals_[b].sum +=
        values[b].rainfall * std::sqrt(log_variance(*weighing_.normals(), b, month));
    ++of_normals_[b].values;
  }
}

double MeanError::error_of_normal(std::size_t basin) const {
  const OfNormals& of = of_normals_[basin];
  return of.values == 0 ? 0 : of.sum / static_cast<double>(of.values);
}

MeanError::Variance MeanError::variance(const StepVariance& of_field) const {
  std::size_t most = 1;
  for (const Pair& pair : pairs_) most = std::max(most, pair.steps);
  std::vector<SquaredDifference> whole;
  std::vector<SquaredDifference> passing;
  std::unordered_set<std::uint32_t> gauges;
  for (const Pair& pair : pairs_) {
    if (pair.steps < 2 || 2 * pair.steps < most) continue;
    const auto count = static_cast<double>(pair.steps);
    const double mean = pair.sum / count;
    const double scatter = (pair.squares - pair.sum * mean) / (count - 1);
    const double over_all = scatter / static_cast<double>(steps_);
    whole.push_back({pair.a, pair.b, mean * mean - scatter / count + over_all});
    passing.push_back({pair.a, pair.b, over_all});
    gauges.insert({pair.a, pair.b});
  }
  return {of_field.of(whole, gauges.size()), of_field.of(passing, gauges.size()).variance};
}

MeanError::Squares MeanError::squares(const RainfallError& error, unsigned threads) const {
  const std::size_t basins = weighing_.basins().size();
  const std::size_t steps = std::min(sample_.steps(), weighed_steps);
  std::vector<CellAccount> accounts(steps);
  std::vector<std::vector<BasinRainfall>> values(steps);
  std::vector<std::vector<double>> at_step(steps);
  in_parallel(steps, threads, [&](std::size_t, std::size_t i) {
    values[i] = error.parts().at(sample_[i * sample_.steps() / steps], accounts[i]);
    at_step[i] = error.mean_squares(accounts[i].change);
  });
  std::vector<double> count(basins, 0);
  Squares result{std::vector<double>(basins, 0), {}};
  for (std::size_t i = 0; i < steps; ++i) {
    for (std::size_t b = 0; b < basins; ++b) {
      if (std::isnan(values[i][b].rainfall)) continue;
      result.mean[b] += at_step[i][b];
      ++count[b];
    }
  }
  std::vector<CellWeight> mean_change;
  for (std::size_t i = 0; i < steps; ++i) {
    for (const CellWeight& c : accounts[i].change) {
      if (!std::isnan(values[i][c.basin].rainfall))
        mean_change.push_back({c.basin, c.cell, c.weight / count[c.basin]});
    }
  }
  result.of_mean = error.mean_squares(mean_change);
  for (std::size_t b = 0; b < basins; ++b) result.mean[b] /= count[b];  // NaN without any step
  return result;
}

std::vector<double> MeanError::result(unsigned threads) {
  std::vector<double> errors(weighing_.basins().size(), std::numeric_limits<double>::quiet_NaN());
  const RainfallError error(rainfall_, weighing_, sample_, threads);
  shortfall_ = error.shortfall();
  if (!shortfall_.empty()) return errors;
  Variance field = variance(error.model().variance());
  if (std::isnan(field.whole.variance)) {
    if (!field.whole.is_even || !error.parts().has_normals()) {
      shortfall_ = "too few gauges report together, or their means are all the same";
      return errors;
    }
    field = {{0, field.whole.degrees, field.whole.gauges}, 0};
  }
  const double passing = std::isnan(field.passing) ? 0 : field.passing;
  const double lasting = field.whole.variance - passing;
  const double widening = StepVariance::widening(field.whole.degrees);
  const Squares weights = squares(error, threads);
  for (std::size_t b = 0; b < errors.size(); ++b) {
    const double square = passing * weights.mean[b] + lasting * weights.of_mean[b];
    if (std::isnan(square)) continue;
    const double of_field = error.parts().normal(b) * widening * std::sqrt(std::max(0.0, square));
    errors[b] = of_normals_[b].values == 0 ? of_field : std::hypot(of_field, error_of_normal(b));
  }
  return errors;
}

}  // namespace thiessen
