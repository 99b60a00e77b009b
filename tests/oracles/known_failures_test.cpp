// Points that broke other programs, from their public trackers, and the sizes at which some never
// end, against CGAL's Delaunay triangulation of the same points. (T021, T028.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "oracles/same_as_cgal.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

/// Built at once, in the order given point by point, and in the other order.
void expect_same_as_cgal(const std::vector<Point>& points) {
  expect_sound_and_same_as_cgal<2>(points);
  const auto simplices = plain_simplices(tessellation_of(points));
  Tessellation<2> forward, backward;
  for (auto p = points.begin(); p != points.end(); ++p) forward.add(*p);
  for (auto p = points.rbegin(); p != points.rend(); ++p) backward.add(*p);
  EXPECT_EQ(plain_simplices(forward), simplices);
  EXPECT_EQ(plain_simplices(backward), simplices);
}

TEST(KnownFailures, jts_issue_20_crossing_edges) {
  expect_same_as_cgal(std::vector<Point>{{-36.936336898963525, -9.508890876984978},
                                         {-36.7320806786612, -9.27520427373948},
                                         {-36.93633689896362, -9.508890876985053},
                                         {-36.9363441204872, -9.508896761408002},
                                         {-36.95085774213237, -9.34734748027729},
                                         {-36.92859286275029, -9.491951983474776},
                                         {-37.10160515698933, -9.242356362160889}});
}

TEST(KnownFailures, geos_issue_1040_cells_overlapped) {
  expect_same_as_cgal(std::vector<Point>{{6.6584, 53.583000000000006},
                                         {6.6576, 53.583600000000004},
                                         {6.657, 53.5848},
                                         {6.6572000000000005, 53.5842}});
}

TEST(KnownFailures, shapely_issue_2264_one_cell_covered_the_others) {
  expect_same_as_cgal(std::vector<Point>{{366.99763488064747, -45.610000000000014},
                                         {366.2381975042589, -45.339682883479995},
                                         {366.0603171165201, -45.161802495741185},
                                         {365.7900000000001, -44.40236511935221}});
}

TEST(KnownFailures, opencv_issue_22902_a_point_was_nowhere) {
  expect_same_as_cgal(std::vector<Point>{{-1.18061450447522, 2.22044604925031E-16},
                                         {0.199999999989984, 1.38061450446519},
                                         {1.58061450445518, -2.22044604925031E-16},
                                         {-1.08061450447519, 1.11022302462516E-16},
                                         {0.199999999989984, -1.28061450446519},
                                         {0.199999999989984, 1.28061450446519},
                                         {1.48061450445516, -1.11022302462516E-16},
                                         {-1.18061450447522, 0},
                                         {1.48061450445516, 0},
                                         {-0.440307252242633, 1.10904469332167}});
}

// Of the analytics toolbox; the first three points failed by themselves, too.
TEST(KnownFailures, carto_pull_339_a_circle_of_nothing) {
  const std::vector<Point> points{{4.1829523, 43.6347910},
                                  {4.1829967, 43.6347137},
                                  {4.1829955, 43.6347143},
                                  {4.1829321, 43.6347500}};
  expect_same_as_cgal(points);
  expect_same_as_cgal({points.begin(), points.begin() + 3});
}

TEST(KnownFailures, constrainautor_issue_15_an_edge_of_1e_17) {
  expect_same_as_cgal(std::vector<Point>{{0, 0},
                                         {0.05626429153399996, 0},
                                         {0.024093852080076722, 4.80267923973791e-18},
                                         {0.01379050745122589, 0.1463775332929564},
                                         {0.05177587092034522, 0.015468457826306506},
                                         {0.024093852080076705, -5.204170427930421e-18}});
}

// Seven points that are on one line but for rounding, and one beside it.
TEST(KnownFailures, d3_delaunay_pull_142_a_hull_on_one_line) {
  std::vector<Point> points{{10, 190}};
  for (int i = 0; i < 7; ++i) points.push_back({i * 80.0, i * 50.0 / 7});
  expect_same_as_cgal(points);
}

constexpr std::size_t many = 100000;

/// All at once and, without a hint, one by one; then every other one is deleted.
void expect_to_finish(const std::vector<Point>& points) {
  const Tessellation<2> at_once = tessellation_of(points);
  ASSERT_EQ(at_once.count(), points.size());
  expect_sound(at_once);
  Tessellation<2> one_by_one;
  std::vector<PointId> numbers;
  numbers.reserve(points.size());
  for (const Point p : points) numbers.push_back(one_by_one.add(p));
  ASSERT_TRUE(plain_simplices(one_by_one) == plain_simplices(at_once));
  std::vector<Point> left;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i % 2 == 0) {
      one_by_one.remove(numbers[i]);
    } else {
      left.push_back(points[i]);
    }
  }
  ASSERT_TRUE(plain_simplices(one_by_one) == plain_simplices(tessellation_of(left)));
}

/// Neither in order nor against it.
std::vector<Point> shuffled(Seeded& seeded, std::vector<Point> points) {
  std::shuffle(points.begin(), points.end(), seeded.generator());
  return points;
}

// Without CGAL, which takes twenty seconds here.
TEST(KnownFailures, many_points_on_one_line) {
  Seeded seeded;
  const std::vector<Point> points = families::line(many, {0, 0}, {1, 2});
  const Tessellation<2> tessellation = tessellation_of(points);
  const std::vector<PointId> in_order = tessellation.along_line();
  ASSERT_EQ(in_order.size(), many);
  for (std::size_t i = 0; i < many; ++i) ASSERT_EQ(tessellation.position(in_order[i]), points[i]);
  expect_to_finish(points);
  expect_to_finish(shuffled(seeded, points));
}

// JCash/voronoi issue 48: x = y, exactly.
TEST(KnownFailures, many_points_on_a_diagonal) {
  expect_to_finish(families::line(many, {0, 0}, {0.1, 0.1}));
}

// On a line but for rounding.
TEST(KnownFailures, many_points_along_a_line) {
  Seeded seeded;
  const std::vector<Point> points = families::line(many, {0, 0}, {0.1, 0.3});
  expect_to_finish(points);
  expect_to_finish(shuffled(seeded, points));
}

TEST(KnownFailures, many_points_on_a_circle) {
  Seeded seeded;
  const std::vector<Point> points = families::rounded_circle(many, {0, 0}, 1);
  expect_sound_and_same_as_cgal<2>(points);
  expect_to_finish(points);
  expect_to_finish(shuffled(seeded, points));
}

}  // namespace
}  // namespace thiessen
