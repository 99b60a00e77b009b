#include "geometry/predicates.h"

#include <algorithm>
#include <array>

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

Point circumcentre(Point a, Point b, Point c) {
  std::array<Point, 3> p{b, c, a};
  std::sort(p.rbegin(), p.rend());  // the lexicographically first comes last, as the origin
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

}  // namespace thiessen
