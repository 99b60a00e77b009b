#include "rainfall/errors/rainfall_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "earth/nearest/in_space.h"
#include "geometry/long_sum.h"
#include "rainfall/methods/basin_points.h"

namespace thiessen {
namespace {

constexpr std::size_t points_a_weight = 8;
constexpr std::size_t least_points = 256;
constexpr std::size_t most_points = 4096;

constexpr std::size_t sampled_steps = 2000;
constexpr std::size_t sampled_bytes = std::size_t{16} << 20;

/// A reference to what its user keeps.
std::shared_ptr<const WeighedRainfall> kept(const WeighedRainfall& rainfall) {
  return std::shared_ptr<const WeighedRainfall>(std::shared_ptr<const WeighedRainfall>(),
                                                &rainfall);
}

std::shared_ptr<const FieldModel> fitted_model(const WeighedRainfall& rainfall,
                                               const Weighing& weighing, const StepSample& sample,
                                               unsigned threads) {
  Sites sites(weighing.network().places(), weighing.yardstick().metric);
  StepSample of_sites(sites.size(), std::max<std::size_t>(sample.steps(), 2));
  for (std::size_t t = 0; t < sample.steps(); ++t)
    of_sites.add(by_site(sites, rainfall.cell_readings(sample[t])));
  return std::make_shared<const FieldModel>(weighing, std::move(sites), of_sites, threads);
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

RainfallError::RainfallError(const WeighedRainfall& rainfall, const Weighing& weighing,
                             const StepSample& sample, unsigned threads)
    : RainfallError(kept(rainfall), {}, weighing, sample, threads) {}

RainfallError::RainfallError(std::shared_ptr<const WeighedRainfall> rainfall,
                             const NormalMonth& month, const Weighing& weighing,
                             const StepSample& sample, unsigned threads)
    : parts_(std::move(rainfall), weighing, month),
      fitted_{fitted_model(parts_.rainfall(), weighing, sample, threads), {}} {
  weigh({}, threads);
}

RainfallError::RainfallError(const FittedErrors& like,
                             std::shared_ptr<const WeighedRainfall> rainfall,
                             const NormalMonth& month, unsigned threads)
    : parts_(std::move(rainfall), like.model->weighing(), month), fitted_{like.model, {}} {
  weigh(like.basins, threads);
}

std::shared_ptr<const BasinError> RainfallError::basin_error(std::size_t basin,
                                                             std::span<const SiteWeight> full,
                                                             const BasinError* like) const {
  const Weighing& weighing = model().weighing();
  const Yardstick& yardstick = weighing.yardstick();
  std::vector<SiteWeight> weights(full.begin(), full.end());
  const std::size_t count = std::clamp(points_a_weight * full.size(), least_points, most_points);
  const std::vector<Point> at = basin_points(weighing.basins()[basin], yardstick, count);
  if (like != nullptr && like->points() == at.size())
    return std::make_shared<const BasinError>(*like, std::move(weights));
  std::vector<Direction> points;
  points.reserve(at.size());
  for (const Point p : at) points.push_back(in_space(p, yardstick.metric));
  const double unit = yardstick.metric == Metric::planar ? std::sqrt(yardstick.unit_area) : 1;
  const double side = std::sqrt(weighing.basin_area(basin) / static_cast<double>(at.size())) / unit;
  return std::make_shared<const BasinError>(std::move(weights), std::move(points), side,
                                            model().sites(), model().variogram());
}

void RainfallError::weigh(const std::vector<std::shared_ptr<const BasinError>>& like,
                          unsigned threads) {
  if (!shortfall().empty()) return;
  fitted_.basins.resize(model().weighing().basins().size());
  const WeightsOfBasins all(parts_.full(), fitted_.basins.size(), model().sites());
  in_parallel(fitted_.basins.size(), threads, [&](std::size_t, std::size_t b) {
    fitted_.basins[b] = basin_error(b, all.of(b), like.empty() ? nullptr : like[b].get());
  });
}

std::vector<double> RainfallError::mean_squares(const std::vector<CellWeight>& change) const {
  const WeightsOfBasins changes(change, fitted_.basins.size(), model().sites());
  std::vector<double> squares(fitted_.basins.size());
  for (std::size_t b = 0; b < squares.size(); ++b)
    squares[b] = fitted_.basins[b]->mean_square(changes.of(b));
  return squares;
}

std::vector<BasinRainfall> RainfallError::at(std::span<const double> readings) const {
  if (!shortfall().empty()) return parts_.rainfall().at(readings);
  CellAccount account;
  std::vector<BasinRainfall> result = parts_.at(readings, account);
  const FieldVariance field = model().variance().of(by_site(model().sites(), account.readings));
  if (field.is_even) {
    for (BasinRainfall& basin : result) basin.error_of_step = 0;
  }
  if (std::isnan(field.variance)) return result;
  const WeightsOfBasins changes(account.change, result.size(), model().sites());
  const double widening = StepVariance::widening(field.degrees);
  for (std::size_t b = 0; b < result.size(); ++b) {
    BasinRainfall& basin = result[b];
    if (std::isnan(basin.rainfall)) continue;
    const auto change = changes.of(b);
    basin.error_of_step =
        widening * std::sqrt(field.variance * fitted_.basins[b]->mean_square(change));
    basin.standard_error = basin.error_of_step;
    if (parts_.has_normals()) take_normals(b, change, basin);
  }
  return result;
}

/// Makes the error of the field's mean that of the basin's rainfall.
void RainfallError::take_normals(std::size_t b, std::span<const SiteWeight> change,
                                 BasinRainfall& basin) const {
  LongSum sum;
  sum.add(1);
  for (const SiteWeight& c : change) sum.add(c.weight);
  const double parts = sum.value();
  const double of_field = parts_.normal(b) * parts * basin.error_of_step;
  basin.error_of_step = std::hypot(of_field, basin.rainfall * (1 - 1 / parts));
  basin.error_of_normals = basin.rainfall * parts_.error_of_normal(b);
  basin.standard_error = std::hypot(basin.error_of_step, basin.error_of_normals);
}

}  // namespace thiessen
