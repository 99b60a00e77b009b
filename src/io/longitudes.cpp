#include <algorithm>
#include <cmath>

#include "io/basin_mending.h"

namespace thiessen {
namespace {

void shift(Ring& ring, double degrees) {
  if (degrees == 0) return;
  for (Point& point : ring) point.x += degrees;
}

/// An edge along a pole once round: it has no length, and is there so that the ring may run along
/// the whole antimeridian on either side of it.
bool goes_round_pole(Point a, Point b) {
  return std::abs(b.x - a.x) == 360 && std::abs(a.y) == 90 && a.y == b.y;
}

/// False where the ring winds round the Earth.
bool unwrap(Ring& ring) {
  double turned = 0;
  Point before = ring.empty() ? Point{} : ring[0];
  const Point first = before;
  const auto step = [&](Point next) {
    const double span = next.x - before.x;
    if (std::abs(span) > 180 && !goes_round_pole(before, next))
      turned -= 360 * std::round(span / 360);
    before = next;
  };
  for (Point& point : ring) {
    step(point);
    if (turned != 0) point.x += turned;
  }
  step(first);
  return turned == 0;
}

double least_longitude(const Ring& ring) {
  double least = INFINITY;
  for (const Point point : ring) least = std::min(least, point.x);
  return least;
}

double greatest_longitude(const Ring& ring) {
  double greatest = -INFINITY;
  for (const Point point : ring) greatest = std::max(greatest, point.x);
  return greatest;
}

}  // namespace

bool unwrap_longitudes(MultiPolygon& shape) {
  for (Polygon& polygon : shape) {
    if (!unwrap(polygon.outer)) return false;
    shift(polygon.outer, -360 * std::floor((least_longitude(polygon.outer) + 180) / 360));
    const double middle = (least_longitude(polygon.outer) + greatest_longitude(polygon.outer)) / 2;
    for (Ring& hole : polygon.holes) {
      if (!unwrap(hole)) return false;
      const double hole_middle = (least_longitude(hole) + greatest_longitude(hole)) / 2;
      shift(hole, -360 * std::round((hole_middle - middle) / 360));
    }
  }
  return true;
}

}  // namespace thiessen
