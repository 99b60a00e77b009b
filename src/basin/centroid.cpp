#include "basin/centroid.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

#include "geometry/direction.h"
#include "geometry/long_sum.h"

namespace thiessen {
namespace {

constexpr double degree = std::numbers::pi / 180;

Direction direction_of(Point degrees) {
  const double longitude = degrees.x * degree;
  const double latitude = degrees.y * degree;
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

/// Calls `take` for each edge of a ring, seen from its first corner.
void for_each_edge(const Ring& ring, const std::function<void(Point a, Point b)>& take) {
  for (std::size_t i = 0; i < ring.size(); ++i) take(ring[i], ring[(i + 1) % ring.size()]);
}

/// Twice the area that the ring goes round, positive where it runs counter-clockwise.
double turned_area(const Ring& ring) {
  LongSum sum;
  const Point origin = ring.front();
  for_each_edge(ring, [&](Point a, Point b) {
    sum.add((a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y));
  });
  return sum.value();
}

/// Calls `take` for each ring, with 1 where its edges count as they run and -1 where they count the
/// other way round, so that ground counts once and holes not at all.
void for_each_ring(const MultiPolygon& shape,
                   const std::function<void(const Ring& ring, double sign)>& take) {
  const auto hand = [&](const Ring& ring, double wanted) {
    if (ring.empty()) return;
    const double area = turned_area(ring);
    if (area != 0) take(ring, (area > 0 ? 1 : -1) * wanted);
  };
  for (const Polygon& part : shape) {
    hand(part.outer, 1);
    for (const Ring& hole : part.holes) hand(hole, -1);
  }
}

Point middle_of_corners(const MultiPolygon& shape) {
  Point sum{0, 0};
  double count = 0;
  for (const Polygon& part : shape) {
    for (const Point& corner : part.outer) {
      sum = {sum.x + corner.x, sum.y + corner.y};
      ++count;
    }
  }
  return count == 0 ? sum : Point{sum.x / count, sum.y / count};
}

}  // namespace

Point plane_centroid(const MultiPolygon& shape) {
  if (shape.empty() || shape.front().outer.empty()) return {0, 0};
  const Point origin = shape.front().outer.front();  // so that far coordinates cost no digits
  LongSum area;
  LongSum x;
  LongSum y;
  for_each_ring(shape, [&](const Ring& ring, double sign) {
    for_each_edge(ring, [&](Point a, Point b) {
      a = {a.x - origin.x, a.y - origin.y};
      b = {b.x - origin.x, b.y - origin.y};
      const double turned = sign * (a.x * b.y - b.x * a.y);
      area.add(turned);
      x.add(turned * (a.x + b.x));
      y.add(turned * (a.y + b.y));
    });
  });
  if (area.value() == 0) return middle_of_corners(shape);
  return {origin.x + x.value() / (3 * area.value()), origin.y + y.value() / (3 * area.value())};
}

Point sphere_centroid(const MultiPolygon& shape) {
  // The integral of the outward normal over a spherical polygon is half the sum, over its edges, of
  // each arc's length along the normal of the edge's plane (Stokes). Of a x b what adds up to
  // nothing round the ring is left out, so that small basins keep their digits: with a' = a - o and
  // b' = b - o it is a' x b' + o x (b' - a').
  LongSum x;
  LongSum y;
  LongSum z;
  for_each_ring(shape, [&](const Ring& ring, double sign) {
    const Direction origin = direction_of(ring.front());
    for_each_edge(ring, [&](Point a, Point b) {
      const Direction from = direction_of(a);
      const Direction to = direction_of(b);
      const Direction normal = cross(from, to);
      const double sine = length(normal);
      if (sine == 0) return;
      const double excess = std::atan2(sine, dot(from, to)) / sine - 1;
      const Direction turned = sign * (cross(from - origin, to - origin) + excess * normal);
      x.add(turned.x);
      y.add(turned.y);
      z.add(turned.z);
    });
  });
  const Direction sum{x.value(), y.value(), z.value()};
  if (length(sum) < 1e-14) return middle_of_corners(shape);
  return {std::atan2(sum.y, sum.x) / degree, std::atan2(sum.z, std::hypot(sum.x, sum.y)) / degree};
}

}  // namespace thiessen
