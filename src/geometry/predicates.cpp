#include "geometry/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/double_sum.h"
#include "geometry/lexicographic.h"
#include "geometry/whole_vectors.h"

namespace thiessen {

int exact::orientation(Point a, Point b, Point c, Estimate area) {
  if (area.is_exact_for<2>(a.x, a.y, b.x, b.y, c.x, c.y)) return area.sign();
  return in_whole_numbers(std::array<Point, 3>{a, b, c}, [](const auto& vectors) {
    return determinant::area(vectors.to[0], vectors.to[1]).sign();
  });
}

double doubled_area(Point a, Point b, Point c) {
  // Where the area is more than this share of its terms' magnitudes, three roundings of a term
  // count 8 times at most; with the last one these are the 25 that are promised.
  constexpr double trusted_share = 1.0 / 8;
  const Estimate area = determinant::area(estimated_vector(c, a), estimated_vector(c, b));
  if (std::abs(area.value) >= trusted_share * area.magnitude) return area.value;
  return exact::in_whole_numbers(std::array<Point, 3>{a, b, c}, [](const auto& vectors) {
    return determinant::area(vectors.to[0], vectors.to[1]).to_double(2 * vectors.exponent);
  });
}

int exact::in_circle(Point a, Point b, Point c, Point d, Estimate lift) {
  if (lift.is_exact_for<4>(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y)) return lift.sign();
  return in_whole_numbers(std::array<Point, 4>{a, b, c, d}, [](const auto& vectors) {
    return determinant::in_circle(vectors.to[0], vectors.to[1], vectors.to[2]).sign();
  });
}

// The highest lift decides, because its coefficient in the determinant is an orientation of the
// other three points, which is not zero: of four different points on a circle no three are on a
// line. If d has the highest lift, it is outside. If a corner has it, d is inside where d sees the
// other two corners in the same sense as the corner does.
bool exact::breaks_tie_inside(Point a, Point b, Point c, Point d) {
  std::array<const Point*, 4> points{&a, &b, &c, &d};
  const std::size_t highest = lexicographically_last(points);
  if (highest == 3) return false;
  points[highest] = &d;
  return thiessen::orientation(*points[0], *points[1], *points[2]) > 0;
}

int exact::compare_distance(Point from, Point a, Point b, Estimate difference) {
  if (difference.is_exact_for<2>(from.x, from.y, a.x, a.y, b.x, b.y)) return difference.sign();
  return in_whole_numbers(std::array<Point, 3>{a, b, from}, [](const auto& vectors) {
    return (determinant::square(vectors.to[0]) - determinant::square(vectors.to[1])).sign();
  });
}

namespace {

/// The circumcentre of the points o, p and q where doubles in pairs tell it to the last bit: where
/// the vectors from o are exact, and what is left of the numerators and of the area does not
/// change how they are rounded. An error of 2^-100 of the terms is more than all roundings
/// together: each term goes through four of 2^-103 at most.
std::optional<Point> quick_circumcentre(Point o, Point p, Point q) {
  constexpr double rounding = 0x1p-100;
  const DoubleSum px = DoubleSum::of_difference(p.x, o.x);
  const DoubleSum py = DoubleSum::of_difference(p.y, o.y);
  const DoubleSum qx = DoubleSum::of_difference(q.x, o.x);
  const DoubleSum qy = DoubleSum::of_difference(q.y, o.y);
  if (px.low != 0 || py.low != 0 || qx.low != 0 || qy.low != 0) return {};
  const PlaneVector<HalvedDouble> u{HalvedDouble(px.high), HalvedDouble(py.high)};
  const PlaneVector<HalvedDouble> v{HalvedDouble(qx.high), HalvedDouble(qy.high)};
  bool is_certain = true;
  const auto difference = [&](const DoubleSum& a, const DoubleSum& b) {
    const DoubleSum result = sum_of(a, -1, b);
    const double error = rounding * (std::abs(a.high) + std::abs(b.high));
    is_certain = is_certain && rounds_for_certain(result, error);
    return result.high;
  };
  const DoubleSum u_square = sum_of(u.x * u.x, 1, u.y * u.y);
  const DoubleSum v_square = sum_of(v.x * v.x, 1, v.y * v.y);
  const double twice_area = 2 * difference(u.x * v.y, u.y * v.x);
  const double x = difference(product_of(u_square, v.y), product_of(v_square, u.y));
  const double y = difference(product_of(v_square, u.x), product_of(u_square, v.x));
  if (!is_certain) return {};
  return Point{o.x + x / twice_area, o.y + y / twice_area};
}

}  // namespace

// The first point is the origin.
Point exact::circumcentre(Point a, Point b, Point c) {
  const std::array<Point, 3> p{b, c, a};
  return exact::in_whole_numbers(p, [&p](const auto& vectors) {
    const auto& [u, v] = vectors.to;
    const auto u_square = determinant::square(u);
    const auto v_square = determinant::square(v);
    const double twice_area = 2 * determinant::area(u, v).to_double(2 * vectors.exponent);
    const auto over_area = [&](const auto& numerator) {
      return numerator.to_double(3 * vectors.exponent) / twice_area;
    };
    return Point{p.back().x + over_area(u_square * v.y - v_square * u.y),
                 p.back().y + over_area(v_square * u.x - u_square * v.x)};
  });
}

// The lexicographically first of the three is the origin.
Point circumcentre(Point a, Point b, Point c) {
  if (b < a) std::swap(a, b);
  if (c < a) std::swap(a, c);
  const auto centre = quick_circumcentre(a, b, c);
  return centre ? *centre : exact::circumcentre(a, b, c);
}

}  // namespace thiessen
