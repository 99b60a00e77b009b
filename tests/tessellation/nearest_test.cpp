// Looking for places: the nearest point, the point at a position, the simplex that holds one.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tessellation/simplices.h"
#include "tessellation/space_families.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

template <typename Constant>
class Nearest : public InDimension<Constant> {};
template <typename Constant>
class Find : public InDimension<Constant> {};
template <typename Constant>
class Locate : public InDimension<Constant> {};
TYPED_TEST_SUITE(Nearest, PlaneAndSpace);
TYPED_TEST_SUITE(Find, PlaneAndSpace);
TYPED_TEST_SUITE(Locate, PlaneAndSpace);

/// Near, on, half-way between and far off some points; often equally far from many.
template <int Dimension>
PositionIn<Dimension> somewhere(Seeded& seeded, const std::vector<PositionIn<Dimension>>& points) {
  const auto p = coordinates(points[seeded.below(points.size())]);
  const auto q = coordinates(points[seeded.below(points.size())]);
  const std::uint64_t kind = seeded.below(4);
  CoordinatesIn<Dimension> c;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double half = (p[i] + q[i]) / 2;
    const double aside = q[(i + 1) % c.size()] - p[(i + 1) % c.size()];
    c[i] = kind == 0   ? half
           : kind == 1 ? half + aside
           : kind == 2 ? seeded.near(p[i], 2)
                       : p[i] + 10 * (q[i] - p[i]);
    if (!in_exact_range(c[i])) c[i] = 0;
  }
  return position_of<Dimension>(c);
}

TYPED_TEST(Nearest, is_the_one_found_by_looking_at_each) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1); ++round) {
    for (const FamilyIn<d>& family : families::all_in<d>(seeded, 150)) {
      SCOPED_TRACE(family.name);
      const auto& points = family.points;
      const Tessellation<d> tessellation = tessellation_of(points);
      for (int i = 0; i < 200; ++i) {
        const PositionIn<d> to = somewhere<d>(seeded, points);
        const auto found = tessellation.nearest(to);
        ASSERT_TRUE(found);
        ASSERT_EQ(tessellation.position(*found), *nearest_one_by_one(points, to));
        const PointId hint = *tessellation.nearest(points[seeded.below(points.size())]);
        ASSERT_EQ(tessellation.nearest(to, hint), found);
      }
    }
  }
}

TYPED_TEST(Nearest, finds_all_that_are_as_near) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 100)) {
    SCOPED_TRACE(family.name);
    const std::vector<PositionIn<d>> points = distinct(family.points);
    const Tessellation<d> tessellation = tessellation_of(points);
    std::vector<PointId> nearest;
    for (int i = 0; i < 50; ++i) {
      const PositionIn<d> to = somewhere<d>(seeded, points);
      tessellation.find_nearest(to, {}, nearest);
      std::vector<PositionIn<d>> found;
      for (const PointId p : nearest) found.push_back(tessellation.position(p));
      std::sort(found.begin(), found.end());
      const PositionIn<d> best = *nearest_one_by_one(points, to);
      std::vector<PositionIn<d>> expected;
      std::copy_if(points.begin(), points.end(), std::back_inserter(expected),
                   [&](const auto& p) { return compare_distance(to, p, best) == 0; });
      ASSERT_EQ(found, expected);
    }
  }
}

// T019, T020.
TEST(NearestInPlane, of_equally_near_points_is_the_first_by_coordinates) {
  const Tessellation<2> tessellation = tessellation_of(families::whole_circle({0, 0}));
  EXPECT_EQ(tessellation.position(*tessellation.nearest({0, 0})), (Point{-325, 0}));
  std::vector<PointId> nearest;
  tessellation.find_nearest({0, 0}, {}, nearest);
  EXPECT_EQ(nearest.size(),
            60u);  // 325^2 = 5^4 13^2 is a sum of two squares in 4 (4 + 1) (2 + 1) ways
}

TEST(NearestInSpace, of_a_sphere_is_every_point) {
  const std::vector<SpacePoint> sphere = families::whole_sphere(29, {0, 0, 0});
  const Tessellation<3> tessellation = tessellation_of(sphere);
  std::vector<PointId> nearest;
  tessellation.find_nearest({0, 0, 0}, {}, nearest);
  EXPECT_EQ(nearest.size(), 72u);  // (5, 2, 0): 24, (4, 3, 2): 48
}

// A position off the line or plane that the points span has a nearest point too.
TEST(NearestInSpace, looks_from_off_the_line_or_plane) {
  Seeded seeded;
  for (const std::vector<SpacePoint>& points :
       {families::line_in_space(20, {0, 0, 0}, {1, 2, -3}),
        families::on_plane(families::lattice(64, 1, {0, 0}, 0), {0, 0, 0}, 2, -1)}) {
    const Tessellation<3> tessellation = tessellation_of(points);
    for (int i = 0; i < 200; ++i) {
      const SpacePoint to{std::round(seeded.uniform(-5, 20)), std::round(seeded.uniform(-5, 20)),
                          std::round(seeded.uniform(-5, 20))};
      ASSERT_EQ(tessellation.position(*tessellation.nearest(to)), *nearest_one_by_one(points, to));
    }
  }
}

template <int Dimension>
std::vector<PositionIn<Dimension>> unit_points(Seeded& seeded, std::size_t count) {
  if constexpr (Dimension == 2) {
    return families::uniform(seeded, count);
  } else {
    return families::uniform_in_space(seeded, count);
  }
}

TYPED_TEST(Nearest, takes_any_hint) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  const std::vector<PositionIn<d>> points = unit_points<d>(seeded, 300);
  Tessellation<d> tessellation;
  const std::vector<PointId> ids = tessellation.add_all(points);
  const PointId gone = ids[7];
  tessellation.remove(gone);
  std::vector<PositionIn<d>> left = points;
  left.erase(left.begin() + 7);
  for (int i = 0; i < 100; ++i) {
    const PositionIn<d> to = unit_points<d>(seeded, 1).front();
    const PositionIn<d> expected = *nearest_one_by_one(left, to);
    for (const PointId hint : {ids[8], gone, infinite_point, PointId{100000}, no_point}) {
      ASSERT_EQ(tessellation.position(*tessellation.nearest(to, hint)), expected);
      ASSERT_EQ(tessellation.position(*tessellation.find(expected, hint)), expected);
    }
  }
}

TYPED_TEST(Nearest, does_without_signposts_that_are_gone) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  std::vector<PositionIn<d>> points = unit_points<d>(seeded, 1000);
  Tessellation<d> tessellation;
  std::vector<PointId> ids = tessellation.add_all(points);
  for (std::size_t i = 20; i < ids.size(); ++i) tessellation.remove(ids[i]);
  points.resize(20);
  for (int i = 0; i < 300; ++i) {
    const PositionIn<d> to = unit_points<d>(seeded, 1).front();
    ASSERT_EQ(tessellation.position(*tessellation.nearest(to)), *nearest_one_by_one(points, to));
  }
}

TYPED_TEST(Find, finds_what_is_there_and_nothing_else) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 100)) {
    SCOPED_TRACE(family.name);
    const std::vector<PositionIn<d>> points = distinct(family.points);
    const Tessellation<d> tessellation = tessellation_of(points);
    for (int i = 0; i < 100; ++i) {
      const PositionIn<d> at = somewhere<d>(seeded, points);
      const bool there = std::binary_search(points.begin(), points.end(), at);
      const auto found = tessellation.find(at);
      ASSERT_EQ(found.has_value(), there);
      if (found) {
        ASSERT_EQ(tessellation.position(*found), at);
      }
    }
    for (const auto& p : points) {
      ASSERT_TRUE(tessellation.find(p));
      ASSERT_EQ(tessellation.position(*tessellation.find(p)), p);
    }
  }
}

TYPED_TEST(Locate, finds_a_simplex_that_holds_the_position) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  const std::vector<PositionIn<d>> points = unit_points<d>(seeded, 400);
  Tessellation<d> tessellation;
  const std::vector<PointId> ids = tessellation.add_all(points);
  const Structure<d>& structure = tessellation.structure();
  for (int i = 0; i < 500; ++i) {
    auto c = coordinates(unit_points<d>(seeded, 1).front());
    for (double& x : c) x = i % 2 == 0 ? x : 3 * x - 1;
    const PositionIn<d> at = position_of<d>(c);
    const VertexId v = i % 3 == 0 ? tessellation.locate(at)
                                  : tessellation.locate(at, ids[seeded.below(ids.size())]);
    const auto simplex = structure.template simplex<d>(v);
    const std::size_t infinite = Structure<d>::template infinite_corner<d>(simplex);
    if (infinite <= d) {
      ASSERT_EQ(structure.template orientation_with<d>(simplex, infinite, at), 1);
      continue;
    }
    for (std::size_t k = 0; k <= d; ++k)
      ASSERT_GE(structure.template orientation_with<d>(simplex, k, at), 0);
  }
}

TYPED_TEST(Locate, finds_the_segment_on_a_line) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  const std::vector<PointId> ids =
      tessellation.add_all(std::vector<PositionIn<d>>{{0, 0}, {1, 1}, {2, 2}, {4, 4}});
  const Topology<d>& topology = tessellation.topology();
  const VertexId within = tessellation.locate({3, 3});
  EXPECT_EQ(topology.forming(within)[0], ids[2]);
  EXPECT_EQ(topology.forming(within)[1], ids[3]);
  const VertexId before = tessellation.locate({-1, -1});
  EXPECT_TRUE(topology.is_infinite(before));
  EXPECT_LT(topology.corner_of(before, ids[0]), 2u);
  const VertexId after = tessellation.locate({9, 9});
  EXPECT_TRUE(topology.is_infinite(after));
  EXPECT_LT(topology.corner_of(after, ids[3]), 2u);
}

TYPED_TEST(Locate, takes_far_hints_through_a_needle) {
  constexpr int d = TestFixture::dimension;
  std::vector<PositionIn<d>> points;
  for (int i = 0; i < 2000; ++i) points.push_back({1e3 * i, i % 2 == 0 ? 0.0 : 1e-6});
  if constexpr (d == 3) points.push_back({1e6, 0, 1e-6});
  Tessellation<d> tessellation;
  const std::vector<PointId> ids = tessellation.add_all(points);
  expect_sound(tessellation);
  EXPECT_EQ(tessellation.find(points.front(), ids[1999]), ids.front());
  EXPECT_EQ(tessellation.find(points[1999], ids.front()), ids[1999]);
}

}  // namespace
}  // namespace thiessen
