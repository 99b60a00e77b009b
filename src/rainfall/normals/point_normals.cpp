#include "rainfall/normals/point_normals.h"

#include <cmath>

namespace thiessen {

std::vector<std::vector<double>> point_normals(const NormalField* normals, std::size_t basin,
                                               const std::vector<Point>& points) {
  std::vector<std::vector<double>> all;
  for (const NormalMonth& month : months_of(normals)) {
    std::vector<double>& of_month = all.emplace_back();
    of_month.reserve(points.size());
    const double reference = reference_normal(*normals, month);
    for (const Point p : points) {
      const double normal = normal_at(*normals, basin, p, month);
      of_month.push_back((std::isnan(normal) ? basin_normal(*normals, basin, month) : normal) /
                         reference);
    }
  }
  return all;
}

}  // namespace thiessen
