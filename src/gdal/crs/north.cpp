#include "gdal/crs/north.h"

#include <cmath>

#include "gdal/crs/transformation.h"

namespace thiessen {
namespace {

/// How far from up north may be: the tangent of its angle.
constexpr double tangent_of_five_degrees = 0.0875;
constexpr double tangent_of_45_degrees = 1;

/// Finds where north is at points of a CRS.
class North {
 public:
  explicit North(const Crs& crs) : to_earth_(crs, Crs::wgs84()), to_crs_(Crs::wgs84(), crs) {}

  bool knows(Point at) { return to_earth_(at).has_value(); }
  /// Whether north is up at a point, within an angle of this tangent.
  bool is_up(Point at, double tangent) {
    const auto there = to_earth_(at);
    if (!there) return true;
    const double step = there->y < 89 ? 0.01 : -0.01;
    const auto north = to_crs_({there->x, there->y + step});
    if (!north) return false;
    const double east_shift = (north->x - at.x) / step;
    const double north_shift = (north->y - at.y) / step;
    return north_shift > 0 && std::abs(east_shift) < tangent * north_shift;
  }

 private:
  Transformation to_earth_;
  Transformation to_crs_;
};

}  // namespace

bool north_is_up(const Crs& crs, const Box& map) {
  if (crs.geographic()) return true;
  North north(crs);
  if (!north.knows(map.centre())) return true;
  if (!north.is_up(map.centre(), tangent_of_five_degrees)) return false;
  for (const Point corner :
       {map.low, Point{map.low.x, map.high.y}, map.high, Point{map.high.x, map.low.y}}) {
    if (!north.is_up(corner, tangent_of_45_degrees)) return false;
  }
  return true;
}

}  // namespace thiessen
