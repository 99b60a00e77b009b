#include "rainfall/methods/isohyetal_rainfall.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "rainfall/methods/basin_points.h"
#include "rainfall/methods/isohyets.h"
#include "rainfall/normals/point_normals.h"
#include "rainfall/normals/relative_readings.h"

namespace thiessen {

IsohyetalRainfall::IsohyetalRainfall(const Weighing& weighing,
                                     std::unique_ptr<const StepRainfall> natural,
                                     std::size_t points, double interval, unsigned threads,
                                     const NormalMonth& month)
    : weighing_(weighing),
      natural_(std::move(natural)),
      points_(weighing.basins().size()),
      normals_(points_.size()),
      month_(month),
      interval_(interval) {
  in_parallel(points_.size(), threads, [&](std::size_t, std::size_t b) {
    points_[b] = basin_points(weighing.basins()[b], weighing.yardstick(), points);
    if (weighing.normals() != nullptr) {
      normals_[b] = std::move(
          point_normals(weighing.normals(), b, points_[b])[place_of(weighing.normals(), month)]);
    }
  });
}

double IsohyetalRainfall::normal_on_outline(std::size_t basin, Point p) const {
  const NormalField* const normals = weighing_.normals();
  if (normals == nullptr) return 1;
  const double normal = normal_at(*normals, basin, p, month_);
  return (std::isnan(normal) ? basin_normal(*normals, basin, month_) : normal) /
         reference_normal(*normals, month_);
}

double IsohyetalRainfall::mean_of(std::size_t basin, RainSurface& surface) const {
  surface.begin_anew();
  std::vector<double> values;
  for (std::size_t i = 0; i < points_[basin].size(); ++i) {
    const double normal = normals_[basin].empty() ? 1 : normals_[basin][i];
    values.push_back(normal * surface.at(points_[basin][i]).rainfall);
  }
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  ValueRange range{*least, *largest};
  const auto look_at = [&](const Ring& ring) {
    for (const Point p : ring) {
      const double value = normal_on_outline(basin, p) * surface.at(p).rainfall;
      range.least = std::min(range.least, value);
      range.largest = std::max(range.largest, value);
    }
  };
  for (const Polygon& part : weighing_.basins()[basin].shape) {
    look_at(part.outer);
    for (const Ring& hole : part.holes) look_at(hole);
  }
  return isohyetal_mean(values, range, interval_);
}

std::vector<BasinRainfall> IsohyetalRainfall::at(std::span<const double> readings) const {
  std::vector<BasinRainfall> basins = natural_->at(readings);
  std::unique_ptr<RainSurface> surface;
  for (std::size_t b = 0; b < basins.size(); ++b) {
    if (std::isnan(basins[b].rainfall)) continue;
    if (!surface) {
      surface =
          surface_of(SurfaceMethod::natural, weighing_.network(), weighing_.yardstick().metric,
                     relative_readings(weighing_.normals(), readings, month_));
    }
    basins[b].rainfall = mean_of(b, *surface);
  }
  return basins;
}

std::vector<BasinWeights> IsohyetalRainfall::weights_at(std::span<const double> readings) const {
  return natural_->weights_at(readings);
}

}  // namespace thiessen
