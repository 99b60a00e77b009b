// The theorems of section 1.2 and the max-min angle criterion of section 3.3 (Lawson), which hold
// for every tessellation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tessellation/simplices.h"
#include "tessellation/space_families.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

double distance(const Point& a, const Point& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}
double distance(const SpacePoint& a, const SpacePoint& b) {
  return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z);
}

template <int Dimension>
PositionIn<Dimension> centre_of(const Tessellation<Dimension>& tessellation, VertexId v) {
  const auto& f = tessellation.topology().forming(v);
  const auto at = [&](std::size_t i) -> const auto& {
    return tessellation.position(f[i]);
  };
  if constexpr (Dimension == 2) {
    return circumcentre(at(0), at(1), at(2));
  } else {
    return circumcentre(at(0), at(1), at(2), at(3));
  }
}

template <typename Constant>
class TheoremsIn : public InDimension<Constant> {
 public:
  static std::vector<PositionIn<Constant::value>> points(Seeded& seeded, std::size_t count) {
    if constexpr (Constant::value == 2) {
      return families::uniform(seeded, count);
    } else {
      return families::uniform_in_space(seeded, count);
    }
  }
  template <typename Visit>
  static void for_each_finite(const Tessellation<Constant::value>& tessellation, Visit&& visit) {
    tessellation.topology().for_each_vertex([&](VertexId v) {
      if (!tessellation.topology().is_infinite(v)) visit(v);
    });
  }
};
TYPED_TEST_SUITE(TheoremsIn, PlaneAndSpace);

// Theorem 1: a vertex is equidistant from its forming points.
TYPED_TEST(TheoremsIn, first_a_vertex_is_as_far_from_each_of_its_forming_points) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  const Tessellation<d> tessellation = tessellation_of(TestFixture::points(seeded, 500));
  TestFixture::for_each_finite(tessellation, [&](VertexId v) {
    const auto centre = centre_of(tessellation, v);
    const auto& forming = tessellation.topology().forming(v);
    const double radius = distance(centre, tessellation.position(forming[0]));
    for (const PointId p : forming)
      ASSERT_NEAR(distance(centre, tessellation.position(p)), radius, 1e-12 * (1 + radius));
  });
}

// Theorem 2: no other point lies within that sphere.
TYPED_TEST(TheoremsIn, second_no_other_point_is_nearer_to_a_vertex) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  const Tessellation<d> tessellation = tessellation_of(TestFixture::points(seeded, 300));
  const Structure<d>& structure = tessellation.structure();
  TestFixture::for_each_finite(tessellation, [&](VertexId v) {
    const auto simplex = structure.template simplex<d>(v);
    tessellation.for_each_point([&](PointId p) {
      if (std::count(simplex.begin(), simplex.end(), p) != 0) return;
      ASSERT_FALSE(structure.template in_conflict<d>(simplex, tessellation.position(p)));
    });
  });
}

// Theorem 3: the boundary between two points' cells lies in the plane that bisects them: so do the
// vertices that the two form.
TYPED_TEST(TheoremsIn, third_a_boundary_bisects_its_points) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  const Tessellation<d> tessellation = tessellation_of(TestFixture::points(seeded, 500));
  TestFixture::for_each_finite(tessellation, [&](VertexId v) {
    const auto centre = centre_of(tessellation, v);
    const auto& forming = tessellation.topology().forming(v);
    for (const PointId p : forming) {
      for (const PointId q : forming) {
        if (p == q) continue;
        const auto a = coordinates(tessellation.position(p));
        const auto b = coordinates(tessellation.position(q));
        const auto c = coordinates(centre);
        double off = 0;
        double size = 1;
        for (std::size_t i = 0; i < a.size(); ++i) {
          off += (c[i] - (a[i] + b[i]) / 2) * (b[i] - a[i]);
          size += std::abs(c[i]);
        }
        ASSERT_NEAR(off, 0, 1e-12 * size);
      }
    }
  });
}

// Every cell of a contiguous pair is nearest to one of the pair: from a vertex's forming points no
// other point's cell comes between.
TYPED_TEST(TheoremsIn, second_a_vertex_is_nearest_to_its_forming_points) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  const std::vector<PositionIn<d>> points = TestFixture::points(seeded, 200);
  const Tessellation<d> tessellation = tessellation_of(points);
  TestFixture::for_each_finite(tessellation, [&](VertexId v) {
    const auto centre = centre_of(tessellation, v);
    if (!in_exact_range(centre)) return;
    const double radius =
        distance(centre, tessellation.position(tessellation.topology().forming(v)[0]));
    const auto nearest = tessellation.nearest(centre);
    ASSERT_NEAR(distance(centre, tessellation.position(*nearest)), radius, 1e-12 * (1 + radius));
  });
}

double smallest_angle(const std::array<Point, 3>& triangle) {
  double smallest = M_PI;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = triangle.at(i);
    const Point b = triangle.at((i + 1) % 3);
    const Point c = triangle.at((i + 2) % 3);
    const double cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double dot = (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
    smallest = std::min(smallest, std::atan2(std::abs(cross), dot));
  }
  return smallest;
}

TEST(MaxMinAngle, would_not_grow_by_the_other_diagonal) {
  Seeded seeded;
  std::size_t convex = 0;
  for (const std::vector<Point>& points :
       {families::uniform(seeded, 2000), families::lattice(400, 1, {0, 0}, 0),
        families::lattice(400, 1, {0, 0}, 0.3), families::rounded_circle(100, {0, 0}, 1)}) {
    const Tessellation<2> tessellation = tessellation_of(points);
    const Topology<2>& topology = tessellation.topology();
    topology.for_each_vertex([&](VertexId v) {
      if (topology.is_infinite(v)) return;
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId w = topology.neighbour(v, i);
        if (topology.is_infinite(w)) continue;
        const Point a = tessellation.position(topology.forming(v)[i]);
        const Point b = tessellation.position(topology.forming(v)[(i + 1) % 3]);
        const Point c = tessellation.position(topology.forming(v)[(i + 2) % 3]);
        const Point across =
            tessellation.position(topology.forming(w)[topology.side_towards(w, v)]);
        if (orientation(a, b, across) <= 0 || orientation(a, across, c) <= 0) continue;
        ++convex;
        const double ours = std::min(smallest_angle({a, b, c}), smallest_angle({across, c, b}));
        const double other =
            std::min(smallest_angle({a, b, across}), smallest_angle({a, across, c}));
        ASSERT_GE(ours, other - 1e-12);
      }
    });
  }
  EXPECT_GT(convex, 5000u);
}

}  // namespace
}  // namespace thiessen
