#include "rainfall/normals/elevation_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thiessen {

double held_logarithm(double logarithm, double of_nearest) {
  constexpr double most = 2 * std::numbers::ln2;  // of most_factor
  return std::clamp(logarithm, of_nearest - most, of_nearest + most);
}

ElevationFit::ElevationFit(std::span<const Point> places, std::span<const double> elevations,
                           std::span<const std::vector<double>> normals, Metric metric,
                           unsigned threads)
    : places_(places.begin(), places.end()), nearest_(places, metric) {
  for (const std::vector<double>& of_month : normals) {
    const auto& fitted = by_month_.emplace_back(
        std::make_unique<const FittedNormals>(places, elevations, of_month, metric, threads));
    const ElevationKriging& kriging = fitted->kriging();
    left_out_error_ += kriging.left_out_error() * kriging.left_out_error();
    nearest_error_ += kriging.nearest_error() * kriging.nearest_error();
  }
  const auto months = static_cast<double>(normals.size());
  left_out_error_ = std::sqrt(left_out_error_ / months);
  nearest_error_ = std::sqrt(nearest_error_ / months);
  find_spacing();
  tell_without();
}

void ElevationFit::at(Point x, std::span<ToldNormal> by_month) const {
  std::vector<NearestGauges::Near> near;
  nearest_.find(x, 1, {}, near);
  const std::size_t nearest = index(near.front().place);
  for (std::size_t m = 0; m < by_month_.size(); ++m)
    by_month[m] = {by_month_[m]->at(x), std::log(by_month_[m]->at_place(nearest))};
}

void ElevationFit::find_spacing() {
  const std::size_t count = std::min(places_.size(), ElevationKriging::neighbours + 1);
  std::vector<NearestGauges::Near> near;
  std::vector<double> squares;
  for (const Point p : places_) {
    nearest_.find(p, count, {}, near);
    squares.push_back(near.back().square);
  }
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  spacing_ = std::sqrt(*middle * std::numbers::pi / static_cast<double>(count));
}

void ElevationFit::tell_without() {
  without_.resize(by_month_.size());
  std::vector<NearestGauges::Near> near;
  for (std::size_t place = 0; place < places_.size(); ++place) {
    nearest_.find(places_[place], 2, {}, near);
    const std::size_t other = index(near.back().place);
    for (std::size_t m = 0; m < by_month_.size(); ++m) {
      const FittedNormals& fitted = *by_month_[m];
      without_[m].push_back(std::exp(
          held_logarithm(std::log(fitted.without(place)), std::log(fitted.at_place(other)))));
    }
  }
}

}  // namespace thiessen
