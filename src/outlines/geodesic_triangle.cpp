#include "outlines/geodesic_triangle.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "earth/sphere/geodesic_chords.h"
#include "outlines/antimeridian.h"
#include "outlines/ring_direction.h"
#include "outlines/winding_polygon.h"
#include "outlines/winding_ring.h"

namespace thiessen {
namespace {

bool is_pole(Point p) {
  return std::abs(p.y) == 90;
}

/// The corners and the bends between them. A corner at a pole stands there twice, at the longitudes
/// of the corners beside it.
Ring ring_of(const std::array<Point, 3>& corners, double tolerance) {
  Ring ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point before = corners.at((i + 2) % 3);
    const Point corner = corners.at(i);
    const Point after = corners.at((i + 1) % 3);
    if (is_pole(corner)) {
      ring.push_back({before.x, corner.y});
      ring.push_back({after.x, corner.y});
    } else {
      ring.push_back(corner);
    }
    const std::vector<Point> bends = geodesic_chords(corner, after, tolerance);
    ring.insert(ring.end(), bends.begin(), bends.end());
  }
  return ring;
}

}  // namespace

MultiPolygon geodesic_triangle(const std::array<Point, 3>& corners, double tolerance) {
  WindingRing ring = ring_the_short_way(ring_of(corners, tolerance));
  // The inside is to the left: to the north of a line that leads eastward round the Earth.
  ring.holds_north = ring.winding > 0;
  ring.holds_south = ring.winding < 0;
  if (ring.winding == 0 && !(signed_area(unwrapped(ring)) > 0)) return {};
  CurvedShape shape;
  if (!add_polygon({ring}, Longitudes::cut, shape).empty()) return {};
  return shape.shape;
}

}  // namespace thiessen
