#include "geometry/voronoi_measures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/whole_vectors.h"

namespace thiessen {
double circumradius(Point a, Point b, Point c) {
  std::array<Point, 3> p{a, b, c};
  std::sort(p.begin(), p.end());
  return exact::in_whole_numbers(p, [](const auto& vectors) {
    const auto& [u, v] = vectors.to;
    const auto u_square = determinant::square(u);
    const auto v_square = determinant::square(v);
    const auto to_double = [&](const auto& number) {
      return number.to_double(3 * vectors.exponent);
    };
    const double area = determinant::area(u, v).to_double(2 * vectors.exponent);
    return std::hypot(to_double(u_square * v.y - v_square * u.y) / area,
                      to_double(u_square * v.x - v_square * u.x) / area) /
           2;
  });
}

double circumradius(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                    const SpacePoint& d) {
  std::array<SpacePoint, 4> p{a, b, c, d};
  std::sort(p.begin(), p.end());
  return exact::in_whole_numbers(p, [](const auto& vectors) {
    const auto& [u, v, w] = vectors.to;
    const auto u_square = determinant::square(u);
    const auto v_square = determinant::square(v);
    const auto w_square = determinant::square(w);
    const auto vw = determinant::cross(v, w);
    const auto wu = determinant::cross(w, u);
    const auto uv = determinant::cross(u, v);
    const auto to_double = [&](const auto& number) {
      return number.to_double(4 * vectors.exponent);
    };
    const double volume = determinant::volume(u, v, w).to_double(3 * vectors.exponent);
    return std::hypot(to_double(u_square * vw.x + v_square * wu.x + w_square * uv.x) / volume,
                      to_double(u_square * vw.y + v_square * wu.y + w_square * uv.y) / volume,
                      to_double(u_square * vw.z + v_square * wu.z + w_square * uv.z) / volume) /
           2;
  });
}

// The sum of the cotangents is a fraction whose numerator is the in-circle determinant, so it
// cancels exactly.
double edge_ratio(Point p, Point q, Point r, Point s) {
  return exact::in_whole_numbers(std::array<Point, 4>{q, r, s, p}, [](const auto& vectors) {
    const auto& [u, v, w] = vectors.to;
    const int exponent = vectors.exponent;
    const double left = determinant::area(u, v).to_double(2 * exponent);
    const double right = determinant::area(w, u).to_double(2 * exponent);
    return determinant::in_circle(w, u, v).to_double(4 * exponent) / left / right;
  });
}

double square_difference(Point from, Point a, Point b) {
  return exact::in_whole_numbers(std::array<Point, 3>{a, b, from}, [](const auto& vectors) {
    return (determinant::square(vectors.to[1]) - determinant::square(vectors.to[0]))
        .to_double(2 * vectors.exponent);
  });
}

// The edge's length divided by half that of pq is the sum of the cotangents at r and s: see
// edge_ratio.
double sector_area(Point p, Point q, Point r, Point s) {
  return exact::in_whole_numbers(std::array<Point, 4>{q, r, s, p}, [](const auto& vectors) {
    const auto& [u, v, w] = vectors.to;
    const int exponent = vectors.exponent;
    const double left = determinant::area(u, v).to_double(2 * exponent);
    const double right = determinant::area(w, u).to_double(2 * exponent);
    const double lift = determinant::in_circle(w, u, v).to_double(4 * exponent);
    return lift / left / right * determinant::square(u).to_double(2 * exponent) / 8;
  });
}

// The edge is along the normal of the triangle p, q, s, up to the centre where the sphere through
// these three passes through t.
SpaceVector<double> voronoi_edge(const SpacePoint& p, const SpacePoint& q, const SpacePoint& r,
                                 const SpacePoint& s, const SpacePoint& t) {
  return exact::in_whole_numbers(std::array<SpacePoint, 5>{q, r, s, t, p}, [](const auto& vectors) {
    const auto& [u, v, w, y] = vectors.to;
    const int exponent = vectors.exponent;
    const double first = determinant::volume(u, v, w).to_double(3 * exponent);
    const double second = determinant::volume(u, w, y).to_double(3 * exponent);
    const double lift = -determinant::in_sphere(u, v, w, y).to_double(5 * exponent);
    const auto normal = determinant::cross(u, w);
    const auto component = [&](const auto& along) {
      return along.to_double(2 * exponent) / first * (lift / second) / 2;
    };
    return SpaceVector<double>{component(normal.x), component(normal.y), component(normal.z)};
  });
}

SpaceVector<double> unit_normal(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  return exact::in_whole_numbers(std::array<SpacePoint, 3>{b, c, a}, [](const auto& vectors) {
    const auto normal = determinant::cross(vectors.to[0], vectors.to[1]);
    const double x = normal.x.to_double(2 * vectors.exponent);
    const double y = normal.y.to_double(2 * vectors.exponent);
    const double z = normal.z.to_double(2 * vectors.exponent);
    const double length = std::hypot(x, y, z);
    return SpaceVector<double>{x / length, y / length, z / length};
  });
}

}  // namespace thiessen
