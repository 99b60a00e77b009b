#include "rainfall/normals/elevation_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thiessen {

double held_logarithm(double logarithm, double of_nearest) {
  constexpr double most = 2 * std::numbers::ln2;  // of most_factor
  return std::clamp(logarithm, of_nearest - most, of_nearest + most);
}

namespace {

/// The places that have a normal in some month.
std::vector<std::size_t> places_with_normals(std::span<const std::vector<double>> normals,
                                             std::size_t places) {
  std::vector<std::size_t> with;
  for (std::size_t place = 0; place < places; ++place) {
    if (std::any_of(normals.begin(), normals.end(),
                    [&](const std::vector<double>& of_month) { return of_month[place] > 0; }))
      with.push_back(place);
  }
  return with;
}

std::vector<Point> chosen(std::span<const Point> places, std::span<const std::size_t> numbers) {
  std::vector<Point> some;
  for (const std::size_t number : numbers) some.push_back(places[number]);
  return some;
}

}  // namespace

ElevationFit::ElevationFit(std::span<const Point> places, std::span<const double> elevations,
                           std::span<const std::vector<double>> normals, Metric metric,
                           unsigned threads)
    : gauges_(places_with_normals(normals, places.size())),
      at_gauges_(chosen(places, gauges_)),
      nearest_(at_gauges_, metric) {
  for (const std::vector<double>& of_month : normals) {
    const auto& fitted = by_month_.emplace_back(
        std::make_unique<const FittedNormals>(places, elevations, of_month, metric, threads));
    const ElevationKriging& kriging = fitted->kriging();
    left_out_error_ += kriging.left_out_error() * kriging.left_out_error();
    nearest_error_ += kriging.nearest_error() * kriging.nearest_error();
    level_error_ += kriging.level_error() * kriging.level_error();
  }
  const auto months = static_cast<double>(normals.size());
  left_out_error_ = std::sqrt(left_out_error_ / months);
  nearest_error_ = std::sqrt(nearest_error_ / months);
  level_error_ = std::sqrt(level_error_ / months);
  find_spacing();
  tell_without(places);
}

void ElevationFit::at(Point x, std::span<ToldNormal> by_month) const {
  std::vector<NearestGauges::Near> near;
  nearest_.find(x, 1, {}, near);
  const std::size_t nearest = gauges_[index(near.front().place)];
  for (std::size_t m = 0; m < by_month_.size(); ++m)
    by_month[m] = {by_month_[m]->at(x), std::log(by_month_[m]->at_place(nearest))};
}

void ElevationFit::find_spacing() {
  const std::size_t count = std::min(at_gauges_.size(), ElevationKriging::neighbours + 1);
  std::vector<NearestGauges::Near> near;
  std::vector<double> squares;
  for (const Point p : at_gauges_) {
    nearest_.find(p, count, {}, near);
    squares.push_back(near.back().square);
  }
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  spacing_ = std::sqrt(*middle * std::numbers::pi / static_cast<double>(count));
}

void ElevationFit::tell_without(std::span<const Point> places) {
  without_.resize(by_month_.size());
  std::vector<NearestGauges::Near> near;
  for (std::size_t place = 0; place < places.size(); ++place) {
    nearest_.find(places[place], 2, {}, near);
    const bool is_itself = gauges_[index(near.front().place)] == place;
    const std::size_t other = gauges_[index((is_itself ? near.back() : near.front()).place)];
    for (std::size_t m = 0; m < by_month_.size(); ++m) {
      const FittedNormals& fitted = *by_month_[m];
      without_[m].push_back(std::exp(
          held_logarithm(std::log(fitted.without(place)), std::log(fitted.at_place(other)))));
    }
  }
}

}  // namespace thiessen
