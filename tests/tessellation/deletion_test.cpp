#include "tessellation/deletion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tessellation/audited.h"
#include "tessellation/simplices.h"
#include "tessellation/space_families.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

template <typename Constant>
class DeletionIn : public InDimension<Constant> {};
TYPED_TEST_SUITE(DeletionIn, PlaneAndSpace);

/// The tessellation is sound and that of exactly these points.
template <int Dimension>
void expect_rebuilt(const Tessellation<Dimension>& tessellation,
                    const std::vector<PositionIn<Dimension>>& points) {
  const Tessellation<Dimension> rebuilt = tessellation_of(points);
  ASSERT_EQ(tessellation.span(), rebuilt.span());
  ASSERT_EQ(tessellation.count(), rebuilt.count());
  ASSERT_EQ(plain_simplices(tessellation), plain_simplices(rebuilt));
  const auto findings = audit(tessellation);
  ASSERT_TRUE(findings.empty()) << name_of(findings.front().fault);
}

template <int Dimension>
void remove_at(Tessellation<Dimension>& tessellation, const PositionIn<Dimension>& position) {
  const auto p = tessellation.find(position);
  ASSERT_TRUE(p);
  tessellation.remove(*p);
  ASSERT_FALSE(tessellation.is_there(*p));
  ASSERT_FALSE(tessellation.find(position));
}

/// Deletes the points in their order, comparing with one built from the rest after each.
template <int Dimension>
void empty_in_order(const std::vector<PositionIn<Dimension>>& points) {
  Tessellation<Dimension> tessellation = tessellation_of(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    remove_at(tessellation, points[i]);
    expect_rebuilt(tessellation,
                   {points.begin() + static_cast<std::ptrdiff_t>(i) + 1, points.end()});
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_EQ(tessellation.span(), Span::nothing);
  for (const auto& p : points) tessellation.add(p);
  expect_rebuilt(tessellation, points);
}

// T007, T029: down to nothing and up again.
TYPED_TEST(DeletionIn, any_order_empties_every_family) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2); ++round) {
    for (const FamilyIn<d>& family : families::all_in<d>(seeded, 30)) {
      SCOPED_TRACE(family.name);
      std::vector<PositionIn<d>> points = distinct(family.points);
      std::shuffle(points.begin(), points.end(), seeded.generator());
      if (points.size() > 30) points.resize(30);
      empty_in_order<d>(points);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TYPED_TEST(DeletionIn, order_of_coordinates_keeps_to_the_hull) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 30)) {
    SCOPED_TRACE(family.name);
    std::vector<PositionIn<d>> points = distinct(family.points);
    if (points.size() > 60) points.resize(60);
    empty_in_order<d>(points);
    std::reverse(points.begin(), points.end());
    empty_in_order<d>(points);
    if (testing::Test::HasFatalFailure()) return;
  }
}

// The dimension falls early: those off the last coordinates' plane or line go first.
TYPED_TEST(DeletionIn, order_by_span_lowers_the_dimension_early) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20); ++round) {
    std::vector<PositionIn<d>> points;
    if constexpr (d == 2) {
      points = distinct(families::small_grid(seeded, 25, 2));
    } else {
      points = distinct(families::small_grid_in_space(seeded, 40, 2));
    }
    std::shuffle(points.begin(), points.end(), seeded.generator());
    const auto span_without = [](const PositionIn<d>& p) {
      const auto c = coordinates(p);
      int zeros = 0;  // of the last ones
      while (zeros < d && c[static_cast<std::size_t>(d - 1 - zeros)] == 0) ++zeros;
      return zeros;
    };
    std::stable_sort(points.begin(), points.end(), [&](const auto& p, const auto& q) {
      return span_without(p) < span_without(q);
    });
    empty_in_order<d>(points);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TYPED_TEST(DeletionIn, one_point_and_adding_it_gives_the_same_again) {
  constexpr int d = TestFixture::dimension;
  Seeded seeded;
  for (const FamilyIn<d>& family : families::all_in<d>(seeded, 60)) {
    SCOPED_TRACE(family.name);
    Tessellation<d> tessellation = tessellation_of(family.points);
    const auto before = plain_simplices(tessellation);
    for (const auto& p : distinct(family.points)) {
      const PointId number = *tessellation.find(p);
      tessellation.remove(number);
      ASSERT_EQ(tessellation.add(p), number);
      ASSERT_EQ(plain_simplices(tessellation), before);
    }
  }
}

TYPED_TEST(DeletionIn, last_point_off_a_line_leaves_the_line) {
  constexpr int d = TestFixture::dimension;
  Tessellation<d> tessellation;
  std::vector<PositionIn<d>> line;
  for (int i = 0; i < 50; ++i) line.push_back({1.0 * i, 2.0 * i});
  tessellation.add_all(line);
  const PointId off = tessellation.add({5, 3});
  EXPECT_EQ(tessellation.span(), Span::plane);
  tessellation.remove(off);
  EXPECT_EQ(tessellation.span(), Span::line);
  expect_rebuilt<d>(tessellation, line);
}

TEST(DeletionInSpace, last_point_off_a_plane_leaves_the_plane) {
  for (const double slope : {0.0, 1.0, -7.0}) {
    const std::vector<SpacePoint> plane =
        families::on_plane(families::lattice(100, 1, {0, 0}, 0), {1, 2, 3}, slope, 2);
    Tessellation<3> tessellation = tessellation_of(plane);
    const PointId off = tessellation.add({1, 1, 99});
    EXPECT_EQ(tessellation.span(), Span::space);
    tessellation.remove(off);
    EXPECT_EQ(tessellation.span(), Span::plane);
    expect_rebuilt<3>(tessellation, plane);
  }
}

// Points on two lines: deleting one's leaves the other, whose points now lie off nothing.
TEST(DeletionInSpace, passes_from_space_over_the_plane_to_a_line) {
  std::vector<SpacePoint> points = families::line_in_space(9, {0, 0, 0}, {1, 1, 1});
  points.insert(points.begin(), {{5, 0, 0}, {0, 5, 0}});
  Tessellation<3> tessellation = tessellation_of(points);
  EXPECT_EQ(tessellation.span(), Span::space);
  remove_at<3>(tessellation, {5, 0, 0});
  EXPECT_EQ(tessellation.span(), Span::plane);
  remove_at<3>(tessellation, {0, 5, 0});
  EXPECT_EQ(tessellation.span(), Span::line);
  expect_rebuilt<3>(tessellation, {points.begin() + 2, points.end()});
}

template <int Dimension>
std::size_t count_neighbours(const Tessellation<Dimension>& tessellation, PointId p) {
  std::size_t count = 0;
  tessellation.for_each_neighbour(p, [&](PointId) { ++count; });
  return count;
}

/// Deletes a point with more neighbours than are gone through one by one, and adds it again.
template <int Dimension>
void delete_one_of_many_neighbours(std::vector<PositionIn<Dimension>> points,
                                   const PositionIn<Dimension>& centre) {
  Tessellation<Dimension> tessellation = tessellation_of(points);
  const PointId p = tessellation.add(centre);
  ASSERT_GT(count_neighbours(tessellation, p), Deletion<Dimension>::many_points);
  tessellation.remove(p);
  expect_rebuilt(tessellation, points);
  tessellation.add(centre);
  points.push_back(centre);
  expect_rebuilt(tessellation, points);
}

// T019: the centre of a circle of a thousand.
TEST(DeletionInPlane, of_a_point_with_many_neighbours) {
  delete_one_of_many_neighbours<2>(families::rounded_circle(1000, {0, 0}, 1), {0, 0});
  delete_one_of_many_neighbours<2>(families::whole_circle({500000, 4000000}), {500000, 4000000});
}

TEST(DeletionInPlane, of_an_apex_over_a_lattice) {
  delete_one_of_many_neighbours<2>(families::lattice(10000, 1, {0, 0}, 0), {50, 1e9});
  delete_one_of_many_neighbours<2>(families::lattice(10000, 1, {0, 0}, 0), {1e9, 1e9});
}

// The points round it lie on the hull's new edge, with more of it on either side, or alone.
TEST(DeletionInPlane, of_a_hull_point_whose_neighbours_lie_on_a_line) {
  std::vector<Point> points = families::line(200, {0, 0}, {1, 0});
  points.push_back({100, -500});
  delete_one_of_many_neighbours<2>(points, {100, 5000});
  delete_one_of_many_neighbours<2>(families::line(200, {0, 0}, {1, 3}), {100, 5000});
  for (Point& p : points) p.y = p.x * p.x * 0x1p-40 + p.y;  // almost on a line
  delete_one_of_many_neighbours<2>(points, {100, 5000});
}

TEST(DeletionInPlane, of_a_hull_point_round_an_arc) {
  std::vector<Point> arc;
  for (const Point p : families::rounded_circle(300, {0, 0}, 1000)) {
    if (p.y > 0) arc.push_back(p);
  }
  delete_one_of_many_neighbours<2>(arc, {0, -1});
}

TEST(DeletionInSpace, of_a_point_with_many_neighbours) {
  Seeded seeded;
  delete_one_of_many_neighbours<3>(families::rounded_sphere(seeded, 500, {0, 0, 0}, 1), {0, 0, 0});
  delete_one_of_many_neighbours<3>(families::whole_sphere(189, {0, 0, 0}), {0, 0, 0});
}

TEST(DeletionInSpace, of_an_apex_over_a_lattice) {
  delete_one_of_many_neighbours<3>(families::lattice_in_space(3375, 1, {0, 0, 0}, 0), {7, 7, 1e7});
}

TEST(DeletionInSpace, of_a_hull_point_whose_neighbours_lie_in_a_plane) {
  std::vector<SpacePoint> points =
      families::on_plane(families::lattice(400, 1, {0, 0}, 0), {0, 0, 0}, 0, 0);
  delete_one_of_many_neighbours<3>(points, {9.5, 9.5, 1e6});
  points.push_back({10, 10, -400});
  delete_one_of_many_neighbours<3>(points, {9.5, 9.5, 1e6});
  std::vector<SpacePoint> tilted =
      families::on_plane(families::lattice(400, 1, {0, 0}, 0), {0, 0, 0}, 2, -1);
  tilted.push_back({10, 10, -4000});
  delete_one_of_many_neighbours<3>(tilted, {9, 9, 5e5});
}

// In the hull's face or edge: the points round it lie on one side, some of them in its plane.
TEST(DeletionInSpace, of_a_point_in_a_face_of_the_hull) {
  std::vector<SpacePoint> points =
      families::on_plane(families::rounded_circle(200, {0, 0}, 300), {0, 0, 0}, 0, 0);
  for (const SpacePoint& p : families::whole_sphere(189, {0, 0, -300})) points.push_back(p);
  delete_one_of_many_neighbours<3>(points, {0, 0, 0});
}

// Many neighbours in a plane and on a line within space.
TEST(DeletionInSpace, of_a_point_with_many_neighbours_in_a_plane) {
  const std::vector<SpacePoint> circle =
      families::on_plane(families::rounded_circle(1000, {0, 0}, 1), {0, 0, 3}, 0, 0);
  delete_one_of_many_neighbours<3>(circle, {0, 0, 3});
  const std::vector<SpacePoint> tilted =
      families::on_plane(families::whole_circle({0, 0}), {0, 0, 3}, 2, -1);
  Tessellation<3> tessellation = tessellation_of(tilted);
  tessellation.remove(tessellation.add({0, 0, 3}));
  expect_rebuilt<3>(tessellation, tilted);
  const std::vector<SpacePoint> line = families::line_in_space(300, {0, 0, 0}, {1, 2, 3});
  delete_one_of_many_neighbours<3>(line, {500, 600, -9000});
}

// Of 2 (n + 1) - 4 simplices one more is what is ever needed, and of numbers n + 1.
TEST(DeletionInPlane, frees_rows_that_are_used_again_first) {
  Seeded seeded;
  const std::vector<Point> points = families::uniform(seeded, 200);
  Tessellation<2> tessellation = tessellation_of(points);
  EXPECT_EQ(tessellation.topology().size(), 398u);
  for (int i = 0; i < often(20000); ++i) {
    PointId p{1 + static_cast<std::uint32_t>(seeded.below(200))};
    tessellation.remove(p);
    EXPECT_EQ(tessellation.add({seeded.uniform(0, 1), seeded.uniform(0, 1)}), p);
  }
  EXPECT_EQ(tessellation.count(), 200u);
  EXPECT_EQ(tessellation.topology().size(), 398u);
  EXPECT_EQ(tessellation.topology().point_limit(), 201u);
  expect_sound(tessellation);
}

TEST(DeletionInSpace, frees_rows_that_are_used_again_first) {
  Seeded seeded;
  Tessellation<3> tessellation = tessellation_of(families::uniform_in_space(seeded, 200));
  std::size_t most = tessellation.topology().size();
  for (int i = 0; i < often(3000); ++i) {
    PointId p{1 + static_cast<std::uint32_t>(seeded.below(200))};
    const std::size_t used = plain_simplices(tessellation).size();
    tessellation.remove(p);
    ASSERT_EQ(tessellation.add({seeded.uniform(0, 1), seeded.uniform(0, 1), seeded.uniform(0, 1)}),
              p);
    // Rows grow only where none was left.
    if (tessellation.topology().size() > most) {
      ASSERT_GT(tessellation.topology().size(), used);
    }
    most = std::max(most, tessellation.topology().size());
  }
  EXPECT_EQ(tessellation.topology().point_limit(), 201u);
  EXPECT_LT(most, 200u * 8);
  expect_sound(tessellation);
}

}  // namespace
}  // namespace thiessen
