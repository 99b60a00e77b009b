#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/polygon.h"

namespace thiessen::half_planes {

struct LongPoint {
  long double x;
  long double y;
};

/// What is left of a convex ring where `beyond`, linear in the point, is not positive.
template <typename Beyond>
std::vector<LongPoint> kept_part(const std::vector<LongPoint>& ring, Beyond&& beyond) {
  std::vector<LongPoint> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LongPoint p = ring[i];
    const LongPoint q = ring[(i + 1) % ring.size()];
    const long double p_side = beyond(p);
    const long double q_side = beyond(q);
    if (p_side <= 0) kept.push_back(p);
    if ((p_side < 0 && q_side > 0) || (p_side > 0 && q_side < 0)) {
      const long double share = p_side / (p_side - q_side);
      kept.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
    }
  }
  return kept;
}

/// How far p is beyond the bisector of two places, seen from the first; in square units.
struct Bisector {
  Point at;
  Point other;

  long double operator()(LongPoint p) const {
    const long double dx = static_cast<long double>(other.x) - at.x;
    const long double dy = static_cast<long double>(other.y) - at.y;
    return (p.x - at.x - dx / 2) * dx + (p.y - at.y - dy / 2) * dy;
  }
};

/// The Thiessen cell of places[i] within the box, by cutting the box with every bisector: no
/// tessellation is involved. Cost: the number of places.
inline std::vector<LongPoint> long_cell(std::span<const Point> places, std::size_t i,
                                        const Box& box) {
  std::vector<LongPoint> ring{{box.low.x, box.low.y},
                              {box.high.x, box.low.y},
                              {box.high.x, box.high.y},
                              {box.low.x, box.high.y}};
  for (std::size_t j = 0; j < places.size() && !ring.empty(); ++j) {
    if (j != i) ring = kept_part(ring, Bisector{places[i], places[j]});
  }
  return ring;
}

inline Ring cell(std::span<const Point> places, std::size_t i, const Box& box) {
  Ring rounded;
  for (const LongPoint p : long_cell(places, i, box)) {
    const Point q{static_cast<double>(p.x), static_cast<double>(p.y)};
    if (rounded.empty() || rounded.back() != q) rounded.push_back(q);
  }
  while (rounded.size() > 1 && rounded.front() == rounded.back()) rounded.pop_back();
  return rounded;
}

inline long double doubled_area(LongPoint a, LongPoint b, LongPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The bisectors that bound the cell of places[i], or nearly.
inline std::vector<Bisector> bounding_bisectors(std::span<const Point> places, std::size_t i,
                                                const std::vector<LongPoint>& cell) {
  std::vector<Bisector> bounding;
  for (std::size_t j = 0; j < places.size(); ++j) {
    const Bisector bisector{places[i], places[j]};
    long double nearest = -HUGE_VALL;
    long double farthest = 0;
    for (const LongPoint p : cell) {
      nearest = std::max(nearest, bisector(p));
      farthest = std::max(farthest, std::abs(bisector(p)));
    }
    if (j != i && nearest >= -0.1L * farthest) bounding.push_back(bisector);
  }
  return bounding;
}

/// The area that the cell of places[i] has in common with a shape inside the box: for each of its
/// edges the triangle with the box's centre, cut by the bisectors, counted with its sign. Rounding
/// moves it a little, and never much, whatever lies on what.
inline double common_area(std::span<const Point> places, std::size_t i, const Box& box,
                          const MultiPolygon& shape) {
  const std::vector<LongPoint> cell = long_cell(places, i, box);
  if (cell.size() < 3) return 0;
  const std::vector<Bisector> bisectors = bounding_bisectors(places, i, cell);
  const LongPoint top{box.centre().x, box.centre().y};
  long double doubled = 0;
  const auto add_ring = [&](const Ring& ring) {
    for (std::size_t e = 0; e < ring.size(); ++e) {
      const Point next = ring[(e + 1) % ring.size()];
      std::vector<LongPoint> left{top, {ring[e].x, ring[e].y}, {next.x, next.y}};
      for (const Bisector& bisector : bisectors) left = kept_part(left, bisector);
      for (std::size_t k = 1; k + 1 < left.size(); ++k)
        doubled += doubled_area(left[0], left[k], left[k + 1]);
    }
  };
  for (const Polygon& part : shape) {
    add_ring(part.outer);
    for (const Ring& hole : part.holes) add_ring(hole);
  }
  return static_cast<double>(doubled / 2);
}

}  // namespace thiessen::half_planes
