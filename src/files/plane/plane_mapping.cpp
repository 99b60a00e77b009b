#include "files/plane/plane_mapping.h"

#include <cmath>
#include <limits>

#include "earth/sphere/geodesic.h"
#include "geometry/shape_points.h"

namespace thiessen {
namespace {

constexpr double metres_missed_at_most = 0.1;

bool is_on_earth(Point degrees) {
  return is_finite(degrees) && std::abs(degrees.y) <= 90;
}

}  // namespace

PlaneMapping::PlaneMapping(const Crs& from, const Crs& degrees, const ConformalPlane& plane)
    : to_degrees_(from, degrees), plane_(plane) {}

std::vector<bool> PlaneMapping::apply(std::vector<Point>& points) const {
  std::vector<Point> degrees = points;
  std::vector<bool> inside = to_degrees_.apply(degrees);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!inside[i] || !is_on_earth(degrees[i])) {
      inside[i] = false;
      continue;
    }
    const Point there = plane_.forward(degrees[i]);
    inside[i] = is_finite(there) &&
                geodesic_distance(degrees[i], plane_.reverse(there)) <= metres_missed_at_most;
    if (inside[i]) points[i] = there;
  }
  return inside;
}

void PlaneMapping::apply_unproved(std::vector<Point>& points) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  to_degrees_.apply_unproved(points);
  for (Point& p : points) {
    const Point there = is_on_earth(p) ? plane_.forward(p) : Point{none, none};
    p = is_finite(there) ? there : Point{none, none};
  }
}

}  // namespace thiessen
