#include "outlines/ring_direction.h"

#include <algorithm>

namespace thiessen {
namespace {

void turn(Ring& ring, bool counter_clockwise) {
  if (ring.size() < 3 || (signed_area(ring) > 0) == counter_clockwise) return;
  std::reverse(ring.begin() + 1, ring.end());
}

}  // namespace

double signed_area(const Ring& ring) {
  if (ring.empty()) return 0;
  const Point origin = ring[0];
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1];
    twice += (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
  }
  return twice / 2;
}

void turn_rings(MultiPolygon& shape) {
  for (Polygon& polygon : shape) {
    turn(polygon.outer, true);
    for (Ring& hole : polygon.holes) turn(hole, false);
  }
}

}  // namespace thiessen
