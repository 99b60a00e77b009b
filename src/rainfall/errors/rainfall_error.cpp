#include "rainfall/errors/rainfall_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "earth/nearest/in_space.h"
#include "earth/sphere/units.h"
#include "geometry/long_sum.h"
#include "rainfall/errors/distance_classes.h"
#include "rainfall/errors/variogram_fit.h"
#include "rainfall/methods/basin_points.h"

namespace thiessen {
namespace {

constexpr std::size_t points_a_weight = 8;
constexpr std::size_t least_points = 256;
constexpr std::size_t most_points = 4096;

constexpr std::size_t sampled_steps = 2000;
constexpr std::size_t sampled_bytes = std::size_t{16} << 20;

/// A distance that is longer than any between two gauges, or between a gauge and a basin.
double longest_distance(const Weighing& weighing) {
  if (weighing.yardstick().metric == Metric::geodesic) return 2.1 * mean_radius;
  Box box = weighing.frame();
  for (const Point p : weighing.network().places()) box.take_in(p);
  return std::hypot(box.width(), box.height());
}

/// Weights sorted by basin, and within a basin by site, with one entry for each site.
class WeightsOfBasins {
 public:
  WeightsOfBasins(const std::vector<CellWeight>& weights, std::size_t basins, const Sites& sites)
      : first_(basins + 1, 0), count_(basins, 0), sorted_(weights.size()) {
    for (const CellWeight& w : weights) ++first_[w.basin + 1];
    for (std::size_t b = 0; b < basins; ++b) first_[b + 1] += first_[b];
    for (const CellWeight& w : weights)
      sorted_[first_[w.basin] + count_[w.basin]++] = {sites.of_place(index(w.cell)), w.weight};
    for (std::size_t b = 0; b < basins; ++b) merge(b);
  }

  std::span<const SiteWeight> of(std::size_t basin) const {
    return std::span(sorted_).subspan(first_[basin], count_[basin]);
  }

 private:
  void merge(std::size_t basin) {
    const auto weights = std::span(sorted_).subspan(first_[basin], count_[basin]);
    // Weights of one site are sorted too, so that their sum does not depend on the order of the
    // cells.
    std::sort(weights.begin(), weights.end(), [](const SiteWeight& a, const SiteWeight& b) {
      return a.site != b.site ? a.site < b.site : a.weight < b.weight;
    });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < weights.size();) {
      const std::uint32_t site = weights[i].site;
      LongSum sum;
      for (; i < weights.size() && weights[i].site == site; ++i) sum.add(weights[i].weight);
      weights[kept++] = {site, sum.value()};
    }
    count_[basin] = kept;
  }

  std::vector<std::size_t> first_;  // by basin: where its weights begin in sorted_
  std::vector<std::size_t> count_;  // by basin: how many it has
  std::vector<SiteWeight> sorted_;
};

}  // namespace

std::size_t steps_for_errors(std::size_t stations) {
  return steps_within(sampled_bytes, stations, sampled_steps);
}

RainfallError::RainfallError(const ArealRainfall& rainfall, const Weighing& weighing,
                             const StepSample& sample, unsigned threads)
    : rainfall_(rainfall), sites_(weighing.network().places(), weighing.yardstick().metric) {
  DistanceClasses found = distance_classes(by_site(sample), sites_, threads);
  shortfall_ = std::move(found.shortfall);
  if (!shortfall_.empty()) return;
  variogram_.emplace(fit_variogram(found.classes), longest_distance(weighing));
  variance_.emplace(sites_, *variogram_);
  weigh(weighing, threads);
}

StepSample RainfallError::by_site(const StepSample& sample) const {
  StepSample result(sites_.size(), std::max<std::size_t>(sample.steps(), 2));
  for (std::size_t t = 0; t < sample.steps(); ++t)
    result.add(by_site(rainfall_.cell_readings(sample[t])));
  return result;
}

std::vector<double> RainfallError::by_site(const std::vector<double>& of_cell) const {
  std::vector<double> readings(of_cell.size());
  for (std::uint32_t site = 0; site < readings.size(); ++site)
    readings[site] = of_cell[sites_.place_of(site)];
  return readings;
}

void RainfallError::weigh(const Weighing& weighing, unsigned threads) {
  const Yardstick& yardstick = weighing.yardstick();
  const double unit = yardstick.metric == Metric::planar ? std::sqrt(yardstick.unit_area) : 1;
  basins_.resize(weighing.basins().size());
  const WeightsOfBasins all(rainfall_.full_cells(), basins_.size(), sites_);
  in_parallel(basins_.size(), threads, [&](std::size_t, std::size_t b) {
    const auto full = all.of(b);
    const std::size_t count = std::clamp(points_a_weight * full.size(), least_points, most_points);
    std::vector<Direction> points;
    for (const Point p : basin_points(weighing.basins()[b], yardstick, count))
      points.push_back(in_space(p, yardstick.metric));
    const double side =
        std::sqrt(weighing.basin_area(b) / static_cast<double>(points.size())) / unit;
    basins_[b] = std::make_unique<const BasinError>(std::vector(full.begin(), full.end()),
                                                    std::move(points), side, sites_, *variogram_);
  });
}

std::vector<double> RainfallError::mean_squares(const std::vector<CellWeight>& change) const {
  const WeightsOfBasins changes(change, basins_.size(), sites_);
  std::vector<double> squares(basins_.size());
  for (std::size_t b = 0; b < squares.size(); ++b)
    squares[b] = basins_[b]->mean_square(changes.of(b));
  return squares;
}

std::vector<BasinRainfall> RainfallError::at(std::span<const double> readings) const {
  if (!variance_) return rainfall_.at(readings);
  CellAccount account;
  std::vector<BasinRainfall> result = rainfall_.at(readings, account);
  const FieldVariance field = variance_->of(by_site(account.readings));
  if (std::isnan(field.variance)) return result;
  const WeightsOfBasins changes(account.change, result.size(), sites_);
  const double widening = StepVariance::widening(field.degrees);
  for (std::size_t b = 0; b < result.size(); ++b) {
    if (std::isnan(result[b].rainfall)) continue;
    result[b].standard_error =
        widening * std::sqrt(field.variance * basins_[b]->mean_square(changes.of(b)));
  }
  return result;
}

}  // namespace thiessen
