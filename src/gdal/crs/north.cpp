#include "gdal/crs/north.h"

#include <cmath>

#include "gdal/crs/transformation.h"

namespace thiessen {

bool north_is_up(const Crs& crs, Point at) {
  if (crs.geographic()) return true;
  const auto there = Transformation(crs, Crs::wgs84())(at);
  if (!there) return true;
  const double step = there->y < 89 ? 0.01 : -0.01;
  const auto north = Transformation(Crs::wgs84(), crs)({there->x, there->y + step});
  if (!north) return false;
  const double east_shift = (north->x - at.x) / step;
  const double north_shift = (north->y - at.y) / step;
  constexpr double tangent_of_five_degrees = 0.0875;
  return north_shift > 0 && std::abs(east_shift) < tangent_of_five_degrees * north_shift;
}

}  // namespace thiessen
