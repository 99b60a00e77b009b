#include "rainfall/normals/elevation_kriging.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "earth/nearest/in_space.h"
#include "rainfall/errors/distance_classes.h"
#include "rainfall/errors/variogram_fit.h"

namespace thiessen {
namespace {

/// What is left of values once the straight line in elevation that fits best is taken out.
std::vector<double> residuals(std::span<const double> values, std::span<const double> elevations) {
  const auto n = static_cast<double>(values.size());
  const double z = std::accumulate(elevations.begin(), elevations.end(), 0.0) / n;
  const double v = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double zz = 0;
  double zv = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    zz += (elevations[i] - z) * (elevations[i] - z);
    zv += (elevations[i] - z) * (values[i] - v);
  }
  const double slope = zz > 0 ? zv / zz : 0;
  std::vector<double> left;
  left.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    left.push_back(values[i] - v - slope * (elevations[i] - z));
  return left;
}

VariogramModel fitted(std::span<const double> values, std::span<const double> elevations,
                      const Sites& sites) {
  const std::vector<double> left = residuals(values, elevations);
  std::vector<double> by_site(left.size());
  for (std::size_t place = 0; place < left.size(); ++place)
    by_site[sites.of_place(place)] = left[place];
  const std::vector<DistanceClass> classes = distance_classes(by_site, sites);
  const bool any = std::any_of(classes.begin(), classes.end(), [](const DistanceClass& c) {
    return c.distance > 0 && c.semivariance > 0;
  });
  VariogramModel model;
  if (any) model = fit_exponential(classes);
  // Values that lie on one line exactly, or places that almost coincide, leave equations that
  // cannot be solved: so much nugget keeps them apart and changes no digit that counts.
  constexpr double least_nugget = 1e-9;
  const double scale = model.nugget + model.sill;
  model.nugget = scale > 0 ? std::max(model.nugget, least_nugget * scale) : least_nugget;
  return model;
}

}  // namespace

ElevationKriging::ElevationKriging(std::span<const Point> places,
                                   std::span<const double> elevations,
                                   std::span<const double> values, Metric metric, unsigned threads)
    : places_(places.begin(), places.end()),
      elevations_(elevations.begin(), elevations.end()),
      values_(values.begin(), values.end()),
      metric_(metric),
      nearest_(places, metric) {
  at_.reserve(places.size());
  for (const Point p : places) at_.push_back(in_space(p, metric));
  const Sites sites(places, metric);
  variogram_ = fitted(values, elevations, sites);
  keep_covariances(threads);
  leave_out(threads);
}

void ElevationKriging::keep_covariances(unsigned threads) {
  constexpr std::size_t most_places = 1000;
  const std::size_t count = at_.size();
  if (count > most_places) return;
  covariances_.resize(count * (count - 1) / 2);
  in_parallel(count, threads, [&](std::size_t, std::size_t a) {
    for (std::size_t b = 0; b < a; ++b)
      covariances_[a * (a - 1) / 2 + b] = covariance(at_[a], at_[b]);
  });
}

double ElevationKriging::covariance_of(std::size_t a, std::size_t b) const {
  if (covariances_.empty()) return covariance(at_[a], at_[b]);
  if (a < b) std::swap(a, b);
  return covariances_[a * (a - 1) / 2 + b];
}

ElevationKriging::Told ElevationKriging::told(Direction x,
                                              std::span<const NearestGauges::Near> near) const {
  const auto n = static_cast<Eigen::Index>(near.size());
  const auto place = [&](Eigen::Index i) { return index(near[static_cast<std::size_t>(i)].place); };
  double middle = 0;
  for (const auto& at : near) middle += elevations_[index(at.place)] / static_cast<double>(n);
  Eigen::MatrixXd between(n, n);
  Eigen::MatrixXd drift(n, 2);
  Eigen::VectorXd with_x(n);
  Eigen::VectorXd values(n);
  bool is_level = true;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) between(i, j) = covariance_of(place(i), place(j));
    between(i, i) = variogram_.sill + variogram_.nugget;
    drift(i, 0) = 1;
    drift(i, 1) = elevations_[place(i)] - middle;
    with_x(i) = covariance(x, at_[place(i)]);
    values(i) = values_[place(i)];
    is_level = is_level && elevations_[place(i)] == elevations_[place(0)];
  }
  const Eigen::LLT<Eigen::MatrixXd> root(between);  // of the lower triangle
  // All is multiplied by the root's inverse, which turns covariances into those of white noise.
  root.matrixL().solveInPlace(drift);
  root.matrixL().solveInPlace(with_x);
  root.matrixL().solveInPlace(values);
  const double ones = drift.col(0).squaredNorm();
  const double both = drift.col(0).dot(drift.col(1));
  const double lifts = drift.col(1).squaredNorm();
  const double determinant = ones * lifts - both * both;
  const bool slopes = !is_level && determinant > 1e-12 * ones * lifts;
  // The inverse of drift' drift; without a slope only its first entry.
  const double g00 = slopes ? lifts / determinant : 1 / ones;
  const double g01 = slopes ? -both / determinant : 0;
  const double g11 = slopes ? ones / determinant : 0;
  const double v0 = drift.col(0).dot(values);
  const double v1 = drift.col(1).dot(values);
  const double a = g00 * v0 + g01 * v1;
  const double b = g01 * v0 + g11 * v1;
  const double u0 = drift.col(0).dot(with_x);
  const double u1 = drift.col(1).dot(with_x);

  ElevationLine line;
  line.slope = b;
  line.constant = a - b * middle + with_x.dot(values) - u0 * a - u1 * b;
  // (1 - u0, z - middle - u1) is what the drift at x lacks; its square by g is added to what the
  // field leaves.
  const double c0 = 1 - u0;
  const double c1 = -middle - u1;
  const double of_field = variogram_.sill - with_x.squaredNorm();
  line.variance_terms = {of_field + g00 * c0 * c0 + 2 * g01 * c0 * c1 + g11 * c1 * c1,
                         2 * (g01 * c0 + g11 * c1), g11};
  const double calibration = calibration_by(near);
  for (double& term : line.variance_terms) term *= calibration;
  const double level = v0 / ones;
  return {line, level + with_x.dot(values) - u0 * level};
}

/// The mean of what the near places tell and of what all do, as if these were ten more. While
/// places are left out nothing is known yet, and it is 1.
double ElevationKriging::calibration_by(std::span<const NearestGauges::Near> near) const {
  if (calibrations_.empty()) return calibration_;
  constexpr double of_all = 10;
  double sum = of_all * calibration_;
  for (const auto& at : near) sum += calibrations_[index(at.place)];
  return sum / (of_all + static_cast<double>(near.size()));
}

double ElevationKriging::calibration_at(Point x) const {
  std::vector<NearestGauges::Near> near;
  nearest_.find(x, neighbours, {}, near);
  return calibration_by(near);
}

ElevationLine ElevationKriging::at(Point x) const {
  std::vector<NearestGauges::Near> near;
  nearest_.find(x, neighbours, {}, near);
  return told(in_space(x, metric_), near).line;
}

std::vector<NearestGauges::Near> ElevationKriging::others_of(std::size_t place) const {
  std::vector<NearestGauges::Near> near;
  nearest_.find(places_[place], neighbours + 1, {}, near);
  std::erase_if(near, [&](const auto& other) { return index(other.place) == place; });
  near.resize(std::min(near.size(), neighbours));
  return near;
}

ElevationLine ElevationKriging::without(std::size_t place) const {
  return told(at_[place], others_of(place)).line;
}

void ElevationKriging::leave_out(unsigned threads) {
  struct Errors {
    double left_out;
    double nearest;
    double level;
    double expected;
  };
  std::vector<Errors> errors(places_.size());
  in_parallel(places_.size(), threads, [&](std::size_t, std::size_t place) {
    const std::vector<NearestGauges::Near> others = others_of(place);
    const auto [line, level] = told(at_[place], others);
    const double z = elevations_[place];
    errors[place] = {line.value(z) - values_[place],
                     values_[index(others.front().place)] - values_[place], level - values_[place],
                     line.variance(z) + variogram_.nugget};
  });
  double ratios = 0;
  for (std::size_t place = 0; place < errors.size(); ++place) {
    const Errors& of = errors[place];
    told_.push_back(values_[place] + of.left_out);
    left_out_error_ += of.left_out * of.left_out;
    nearest_error_ += of.nearest * of.nearest;
    level_error_ += of.level * of.level;
    ratios += of.left_out * of.left_out / of.expected;
  }
  const auto n = static_cast<double>(places_.size());
  left_out_error_ = std::sqrt(left_out_error_ / n);
  nearest_error_ = std::sqrt(nearest_error_ / n);
  level_error_ = std::sqrt(level_error_ / n);
  calibration_ = ratios / n;
  for (const Errors& of : errors) calibrations_.push_back(of.left_out * of.left_out / of.expected);
}

}  // namespace thiessen
