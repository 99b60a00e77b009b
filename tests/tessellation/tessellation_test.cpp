#include "tessellation/tessellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tessellation/audit.h"
#include "tessellation/families.h"
#include "tessellation/structure.h"

namespace thiessen {
namespace {

void expect_sound(const Tessellation& tessellation) {
  const std::vector<Finding> findings = audit(tessellation);
  for (const Finding& f : findings) {
    ADD_FAILURE() << name_of(f.fault) << " near " << f.place.x << " " << f.place.y;
    if (&f - findings.data() == 5) break;
  }
}

Tessellation tessellation_of(std::span<const Point> points) {
  Tessellation tessellation;
  tessellation.add_all(points);
  return tessellation;
}

std::vector<Point> positions_along_line(const Tessellation& tessellation) {
  std::vector<Point> positions;
  for (const PointId p : tessellation.along_line()) positions.push_back(tessellation.position(p));
  return positions;
}

TEST(Tessellation, of_every_family_is_sound) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1); ++round) {
    for (const std::size_t count : {4u, 30u, 400u, 3000u}) {
      for (const Family& family : families::all(seeded, count)) {
        SCOPED_TRACE(family.name);
        expect_sound(tessellation_of(family.points));
      }
    }
  }
}

TEST(Tessellation, is_the_same_in_whatever_order_the_points_come) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2); ++round) {
    for (Family& family : families::all(seeded, 200)) {
      SCOPED_TRACE(family.name);
      std::vector<Point>& points = family.points;
      const Tessellation first = tessellation_of(points);
      const auto expected = plain_simplices(first);
      const auto expect_same = [&](const Tessellation& other) {
        ASSERT_EQ(other.span(), first.span());
        ASSERT_EQ(plain_simplices(other), expected);
        if (first.span() == Span::plane) return;
        ASSERT_EQ(positions_along_line(other), positions_along_line(first));
      };
      const auto one_by_one = [&] {
        Tessellation tessellation;
        for (const Point p : points) tessellation.add(p);
        return tessellation;
      };
      expect_same(one_by_one());
      std::sort(points.begin(), points.end());
      expect_same(tessellation_of(points));
      expect_same(one_by_one());
      std::reverse(points.begin(), points.end());
      expect_same(one_by_one());
      for (int shuffle = 0; shuffle < 3; ++shuffle) {
        std::shuffle(points.begin(), points.end(), seeded.generator());
        expect_same(tessellation_of(points));
        expect_same(one_by_one());
      }
      // In two batches.
      Tessellation tessellation;
      const auto half = static_cast<std::ptrdiff_t>(points.size() / 2);
      tessellation.add_all(std::vector<Point>(points.begin(), points.begin() + half));
      tessellation.add_all(std::vector<Point>(points.begin() + half, points.end()));
      expect_same(tessellation);
    }
  }
}

TEST(Tessellation, is_sound_after_every_single_insertion) {
  Seeded seeded;
  for (Family& family : families::all(seeded, 40)) {
    SCOPED_TRACE(family.name);
    std::shuffle(family.points.begin(), family.points.end(), seeded.generator());
    Tessellation tessellation;
    for (const Point p : family.points) {
      const PointId id = tessellation.add(p);
      ASSERT_EQ(tessellation.position(id), p);
      ASSERT_TRUE(audit(tessellation).empty());
    }
  }
}

TEST(Tessellation, has_twice_as_many_simplices_as_points_less_two) {
  Seeded seeded;
  const Tessellation tessellation = tessellation_of(families::uniform(seeded, 1000));
  // On the sphere that the infinite point closes: 2 (1000 + 1) - 4.
  EXPECT_EQ(plain_simplices(tessellation).size(), 1998u);
}

TEST(Tessellation, of_four_corners_and_a_centre_is_four_simplices) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  const double far = std::numeric_limits<double>::infinity();
  const std::set<PlainSimplex> expected{
      {{{0, 0}, {2, 0}, {1, 1}}},     {{{1, 1}, {2, 0}, {2, 2}}},
      {{{0, 2}, {1, 1}, {2, 2}}},     {{{0, 0}, {1, 1}, {0, 2}}},
      {{{0, 0}, {far, far}, {2, 0}}}, {{{2, 0}, {far, far}, {2, 2}}},
      {{{0, 2}, {2, 2}, {far, far}}}, {{{0, 0}, {0, 2}, {far, far}}}};
  EXPECT_EQ(plain_simplices(tessellation_of(points)), expected);
}

TEST(Tessellation, passes_through_every_span) {
  Tessellation tessellation;
  EXPECT_EQ(tessellation.span(), Span::nothing);
  EXPECT_FALSE(tessellation.nearest({0, 0}));
  const PointId first = tessellation.add({1, 1});
  EXPECT_EQ(tessellation.span(), Span::point);
  EXPECT_EQ(tessellation.add({1, 1}), first);
  EXPECT_EQ(tessellation.size(), 1u);
  tessellation.add({3, 3});
  tessellation.add({2, 2});
  EXPECT_EQ(tessellation.span(), Span::line);
  EXPECT_EQ(positions_along_line(tessellation), (std::vector<Point>{{1, 1}, {2, 2}, {3, 3}}));
  tessellation.add({2, 3});
  EXPECT_EQ(tessellation.span(), Span::plane);
  EXPECT_EQ(plain_simplices(tessellation).size(), 6u);
}

TEST(Tessellation, numbers_points_in_their_order_and_equal_ones_alike) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, {1, 0}, {-0.0, 0}, {5, 5}};
  Tessellation tessellation;
  const std::vector<PointId> ids = tessellation.add_all(points);
  ASSERT_EQ(ids.size(), points.size());
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(tessellation.position(ids[i]), points[i]);
  EXPECT_EQ(ids[1], ids[3]);
  EXPECT_EQ(ids[0], ids[4]);
  EXPECT_EQ(ids[5], PointId{5});
  EXPECT_EQ(tessellation.add({7, 7}), PointId{6});
}

TEST(Tessellation, of_equal_points_alone_is_a_point) {
  Tessellation tessellation;
  const std::vector<PointId> ids = tessellation.add_all(std::vector<Point>(1000, Point{3, 4}));
  EXPECT_EQ(tessellation.span(), Span::point);
  EXPECT_EQ(std::count(ids.begin(), ids.end(), ids.front()), 1000);
}

TEST(Tessellation, of_nothing_added_is_nothing) {
  Tessellation tessellation;
  EXPECT_TRUE(tessellation.add_all({}).empty());
  EXPECT_EQ(tessellation.span(), Span::nothing);
}

TEST(Nearest, is_the_one_found_by_looking_at_each) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1); ++round) {
    for (const Family& family : families::all(seeded, 150)) {
      SCOPED_TRACE(family.name);
      const std::vector<Point>& points = family.points;
      const Tessellation tessellation = tessellation_of(points);
      for (int i = 0; i < 300; ++i) {
        const Point p = points[seeded.below(points.size())];
        const Point q = points[seeded.below(points.size())];
        Point to{(p.x + q.x) / 2, (p.y + q.y) / 2};  // often equally far from many
        if (i % 3 == 1) to = {to.x + (q.y - p.y), to.y - (q.x - p.x)};
        if (i % 3 == 2) to = {seeded.near(p.x, 2), seeded.near(p.y, 2)};
        const auto found = tessellation.nearest(to);
        ASSERT_TRUE(found);
        ASSERT_EQ(tessellation.position(*found), *nearest_one_by_one(points, to));
        const PointId hint = *tessellation.nearest(q);
        ASSERT_EQ(tessellation.nearest(to, hint), found);
      }
    }
  }
}

TEST(Nearest, of_equally_near_points_is_the_first_by_coordinates) {
  const std::vector<Point> circle = families::whole_circle({0, 0});
  const Tessellation tessellation = tessellation_of(circle);
  EXPECT_EQ(tessellation.position(*tessellation.nearest({0, 0})), (Point{-325, 0}));
}

TEST(Neighbours, of_a_lattice_point_are_at_least_its_four_next) {
  const Tessellation tessellation = tessellation_of(families::lattice(100, 1, {0, 0}, 0));
  std::vector<Point> neighbours;
  tessellation.for_each_neighbour(*tessellation.nearest({5, 5}), [&](PointId p) {
    neighbours.push_back(tessellation.position(p));
  });
  for (const Point next : {Point{4, 5}, Point{6, 5}, Point{5, 4}, Point{5, 6}}) {
    EXPECT_EQ(std::count(neighbours.begin(), neighbours.end(), next), 1);
  }
}

}  // namespace
}  // namespace thiessen
