#include "tessellation/tessellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "tessellation/audit.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

template <int Dimension>
std::vector<PositionIn<Dimension>> positions_along_line(
    const Tessellation<Dimension>& tessellation) {
  std::vector<PositionIn<Dimension>> positions;
  for (const PointId p : tessellation.along_line()) positions.push_back(tessellation.position(p));
  return positions;
}

template <int Dimension>
Tessellation<Dimension> one_by_one(const std::vector<PositionIn<Dimension>>& points) {
  Tessellation<Dimension> tessellation;
  for (const auto& p : points) tessellation.add(p);
  return tessellation;
}

template <typename Constant>
class TessellationOf : public InDimension<Constant> {};
TYPED_TEST_SUITE(TessellationOf, PlaneAndSpace);

TYPED_TEST(TessellationOf, every_family_is_sound) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1); ++round) {
    for (const std::size_t count : {4u, 30u, 400u, 3000u}) {
      for (const FamilyIn<d>& family : families::all_in<d>(seeded, count)) {
        SCOPED_TRACE(family.name);
        const Tessellation<d> tessellation = tessellation_of(family.points);
        expect_sound(tessellation);
        EXPECT_EQ(positions_of(tessellation), distinct(family.points));
      }
    }
  }
}

// T027 and T031: in whatever order the points come, and by whatever way.
TYPED_TEST(TessellationOf, points_in_any_order_is_the_same) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1); ++round) {
    for (FamilyIn<d>& family : families::all_in<d>(seeded, d == 2 ? 200 : 60)) {
      SCOPED_TRACE(family.name);
      auto& points = family.points;
      const Tessellation<d> first = tessellation_of(points);
      const auto expected = plain_simplices(first);
      const auto expect_same = [&](const Tessellation<d>& other) {
        ASSERT_EQ(other.span(), first.span());
        ASSERT_EQ(plain_simplices(other), expected);
        ASSERT_EQ(positions_along_line(other), positions_along_line(first));
      };
      expect_same(one_by_one<d>(points));
      std::sort(points.begin(), points.end());
      expect_same(tessellation_of(points));
      expect_same(one_by_one<d>(points));
      std::reverse(points.begin(), points.end());
      expect_same(one_by_one<d>(points));
      for (int shuffle = 0; shuffle < 2; ++shuffle) {
        std::shuffle(points.begin(), points.end(), seeded.generator());
        expect_same(tessellation_of(points));
        expect_same(one_by_one<d>(points));
      }
      Tessellation<d> in_two_batches;
      const std::span<const PositionIn<d>> all(points);
      in_two_batches.add_all(all.subspan(0, all.size() / 3));
      in_two_batches.add_all(all.subspan(all.size() / 3));
      expect_same(in_two_batches);
    }
  }
}

TYPED_TEST(TessellationOf, every_family_is_sound_after_every_single_insertion) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (FamilyIn<d>& family : families::all_in<d>(seeded, 30)) {
    SCOPED_TRACE(family.name);
    std::shuffle(family.points.begin(), family.points.end(), seeded.generator());
    Tessellation<d> tessellation;
    for (const auto& p : family.points) {
      const PointId id = tessellation.add(p);
      ASSERT_EQ(tessellation.position(id), p);
      ASSERT_TRUE(audit(tessellation).empty());
    }
  }
}

TYPED_TEST(TessellationOf, nothing_is_nothing) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  EXPECT_TRUE(tessellation.add_all({}).empty());
  EXPECT_EQ(tessellation.span(), Span::nothing);
  EXPECT_TRUE(tessellation.empty());
  EXPECT_FALSE(tessellation.nearest({}));
  EXPECT_FALSE(tessellation.find({}));
  EXPECT_TRUE(tessellation.along_line().empty());
  EXPECT_TRUE(audit(tessellation).empty());
  std::vector<PointId> nearest{PointId{7}};
  tessellation.find_nearest({}, {}, nearest);
  EXPECT_TRUE(nearest.empty());
  tessellation.for_each_point([](PointId) { ADD_FAILURE() << "a point of nothing"; });
  EXPECT_EQ(tessellation.topology().point_limit(), 1u);
}

TYPED_TEST(TessellationOf, equal_points_alone_is_a_point) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  const std::vector<PointId> ids =
      tessellation.add_all(std::vector<PositionIn<d>>(1000, PositionIn<d>{3, 4}));
  EXPECT_EQ(tessellation.span(), Span::point);
  EXPECT_EQ(std::count(ids.begin(), ids.end(), ids.front()), 1000);
  EXPECT_EQ(tessellation.find({3, 4}), ids.front());
  EXPECT_FALSE(tessellation.find({3, 5}));
  EXPECT_EQ(tessellation.along_line(), std::vector<PointId>{ids.front()});
  int neighbours = 0;
  tessellation.for_each_neighbour(ids.front(), [&](PointId) { ++neighbours; });
  EXPECT_EQ(neighbours, 0);
}

// T004, T005, T007.
TYPED_TEST(TessellationOf, growing_points_passes_through_every_span) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  const PointId first = tessellation.add({1, 1});
  EXPECT_EQ(tessellation.span(), Span::point);
  EXPECT_EQ(tessellation.add({1, 1}), first);
  EXPECT_EQ(tessellation.count(), 1u);
  tessellation.add({3, 3});
  EXPECT_EQ(tessellation.span(), Span::line);
  tessellation.add({2, 2});
  tessellation.add({0, 0});
  EXPECT_EQ(positions_along_line(tessellation),
            (std::vector<PositionIn<d>>{{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
  EXPECT_EQ(tessellation.topology().dimension(), 1);
  EXPECT_EQ(count_finite(tessellation), 3u);
  tessellation.add({2, 3});
  EXPECT_EQ(tessellation.span(), Span::plane);
  EXPECT_TRUE(tessellation.along_line().empty());
  EXPECT_EQ(count_finite(tessellation), 3u);
  if constexpr (d == 3) {
    tessellation.add({2, 3, 1});
    EXPECT_EQ(tessellation.span(), Span::space);
    EXPECT_EQ(count_finite(tessellation), 3u);
  }
  expect_sound(tessellation);
}

TYPED_TEST(TessellationOf, equal_points_gives_them_one_number) {
  constexpr int d = TestFixture::dimension;
  const std::vector<PositionIn<d>> points{{0, 0}, {1, 0}, {0, 1}, {1, 0}, {-0.0, 0}, {5, 5}};
  Tessellation<d> tessellation;
  const std::vector<PointId> ids = tessellation.add_all(points);
  ASSERT_EQ(ids.size(), points.size());
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(tessellation.position(ids[i]), points[i]);
  EXPECT_EQ(ids[1], ids[3]);
  EXPECT_EQ(ids[0], ids[4]);  // T010
  EXPECT_EQ(tessellation.count(), 4u);
  EXPECT_EQ(std::set<PointId>(ids.begin(), ids.end()).size(), 4u);
  EXPECT_EQ(tessellation.add({5, 5}), ids[5]);
  EXPECT_EQ(tessellation.add({-0.0, -0.0}), ids[0]);
  EXPECT_EQ(tessellation.add_all(points), ids);
  EXPECT_EQ(tessellation.count(), 4u);
  EXPECT_EQ(tessellation.find({0, -0.0}), ids[0]);
}

TYPED_TEST(TessellationOf, points_visits_each_that_is_there_once) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  const std::vector<PointId> ids =
      tessellation.add_all(std::vector<PositionIn<d>>{{0, 0}, {1, 0}, {0, 1}, {3, 2}});
  tessellation.remove(ids[1]);
  std::vector<PointId> visited;
  tessellation.for_each_point([&](PointId p) { visited.push_back(p); });
  std::vector<PointId> expected{ids[0], ids[2], ids[3]};
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(visited, expected);
  EXPECT_FALSE(tessellation.is_there(ids[1]));
  EXPECT_FALSE(tessellation.is_there(infinite_point));
  EXPECT_FALSE(tessellation.is_there(no_point));
  EXPECT_TRUE(tessellation.is_there(ids[3]));
  EXPECT_EQ(tessellation.add({9, 9}), ids[1]);  // the freed number is given first
}

TEST(TessellationInPlane, has_twice_as_many_simplices_as_points_less_two) {
  Seeded seeded;
  const Tessellation<2> tessellation = tessellation_of(families::uniform(seeded, 1000));
  // On the sphere that the infinite point closes: 2 (1000 + 1) - 4.
  EXPECT_EQ(plain_simplices(tessellation).size(), 1998u);
}

// Of a 3-sphere, with the infinite point: vertices - edges + triangles - tetrahedra = 0, and there
// are twice as many triangles as tetrahedra.
TEST(TessellationInSpace, has_the_euler_characteristic_of_a_sphere) {
  Seeded seeded;
  for (const FamilyIn<3>& family : families::all_in_space(seeded, 100)) {
    SCOPED_TRACE(family.name);
    const Tessellation<3> tessellation = tessellation_of(family.points);
    if (tessellation.span() != Span::space) continue;
    std::size_t edges_twice = 0;
    Star<3> star;
    tessellation.for_each_point([&](PointId p) {
      tessellation.find_star(p, star);
      edges_twice += star.points().size();
    });
    tessellation.find_star(infinite_point, star);
    edges_twice += star.points().size();
    const std::size_t tetrahedra = plain_simplices(tessellation).size();
    EXPECT_EQ(tessellation.count() + 1 + tetrahedra, edges_twice / 2);
  }
}

TEST(TessellationInPlane, of_four_corners_and_a_centre_is_four_simplices) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  const double far = std::numeric_limits<double>::infinity();
  std::vector<PlainSimplex> expected{
      {{{0, 0}, {2, 0}, {1, 1}}},     {{{1, 1}, {2, 0}, {2, 2}}},
      {{{0, 2}, {1, 1}, {2, 2}}},     {{{0, 0}, {1, 1}, {0, 2}}},
      {{{0, 0}, {far, far}, {2, 0}}}, {{{2, 0}, {far, far}, {2, 2}}},
      {{{0, 2}, {2, 2}, {far, far}}}, {{{0, 0}, {0, 2}, {far, far}}}};
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(plain_simplices(tessellation_of(points)), expected);
}

// T031: eight on one sphere and one in the middle: each of the cube's faces, cut in two, and the
// middle make two tetrahedra.
TEST(TessellationInSpace, of_a_cube_and_its_centre_is_twelve_simplices) {
  const Tessellation<3> tessellation =
      tessellation_of(families::with(families::lattice_in_space(8, 2, {0, 0, 0}, 0), {{1, 1, 1}}));
  EXPECT_EQ(count_finite(tessellation), 12u);
  tessellation.topology().for_each_vertex([&](VertexId v) {
    if (tessellation.topology().is_infinite(v)) return;
    const PointId centre = *tessellation.find({1, 1, 1});
    EXPECT_LT(tessellation.topology().corner_of(v, centre), 4u);
  });
}

// T031: twenty faces.
TEST(TessellationInSpace, of_an_icosahedron_and_its_centre_is_twenty_simplices) {
  const Tessellation<3> tessellation =
      tessellation_of(families::with(families::icosahedron(), {{0, 0, 0}}));
  EXPECT_EQ(count_finite(tessellation), 20u);
}

// The plane's tessellation does not depend on where the plane lies in space.
TEST(TessellationInSpace, of_points_in_a_plane_is_theirs) {
  Seeded seeded;
  std::vector<Point> points = families::uniform(seeded, 200);
  for (Point& p : points) p = {std::round(1e6 * p.x), std::round(1e6 * p.y)};
  const Tessellation<2> flat = tessellation_of(points);
  const Tessellation<3> tilted = tessellation_of(families::on_plane(points, {0, 0, 0}, 0, 0));
  EXPECT_EQ(tilted.span(), Span::plane);
  EXPECT_EQ(tilted.topology().dimension(), 2);
  std::vector<PlainSimplex> seen_from_above;
  for (const PlainSimplexIn<3>& s : plain_simplices(tilted))
    seen_from_above.push_back({{{s[0].x, s[0].y}, {s[1].x, s[1].y}, {s[2].x, s[2].y}}});
  std::sort(seen_from_above.begin(), seen_from_above.end());
  EXPECT_EQ(seen_from_above, plain_simplices(flat));
}

}  // namespace
}  // namespace thiessen
