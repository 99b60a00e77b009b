// The tessellation of the plane against CGAL's Delaunay triangulation of the same points.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "oracles/same_as_cgal.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

void expect_same_as_cgal(const std::vector<Point>& points) {
  expect_sound_and_same_as_cgal<2>(points);
}

// T004 to T006, T010 to T020, T022 to T027.
TEST(DelaunayAgainstCgal, every_family) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5); ++round) {
    for (const std::size_t count : {5u, 20u, 150u, 2000u}) {
      for (const Family& family : families::all_in<2>(seeded, count)) {
        SCOPED_TRACE(family.name);
        expect_same_as_cgal(family.points);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(DelaunayAgainstCgal, thousands_of_small_degenerate_sets) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    const std::size_t count = 3 + seeded.below(12);
    std::vector<Point> points = families::small_grid(seeded, count, 1 + seeded.whole(0, 3));
    if (round % 3 == 1) points = families::ulp_cluster(seeded, count, {0.1, 4e6}, 2);
    if (round % 3 == 2) {
      points = families::whole_circle({0, 0});
      std::shuffle(points.begin(), points.end(), seeded.generator());
      points.resize(count);
    }
    expect_same_as_cgal(points);
    if (testing::Test::HasFailure()) return;
  }
}

// Points that broke other programs, from their public trackers and papers.
// T021.
TEST(DelaunayAgainstCgal, shapely_issue_972_a_rectangle) {
  expect_same_as_cgal(std::vector<Point>{
      {20.1273, 18.7303}, {26.5107, 18.7303}, {20.1273, 23.8437}, {26.5107, 23.8437}});
}

TEST(DelaunayAgainstCgal, geos_issue_1062_a_cell_became_a_line) {
  expect_same_as_cgal(std::vector<Point>{{-819831.1, -1007946.473},
                                         {-819831.1, -1007945.994},
                                         {-819829.184, -1007947.9099999999},
                                         {-819829.663, -1007947.9099999999}});
}

TEST(DelaunayAgainstCgal, delaunay_triangulation_issue_32_almost_on_a_line) {
  expect_same_as_cgal(std::vector<Point>{{0, 0}, {1000, 0}, {2000, 40}});
}

// Kettner and others, Classroom examples of robustness problems, 2008.
TEST(DelaunayAgainstCgal, kettners_failure_a1) {
  expect_same_as_cgal(std::vector<Point>{{7.3000000000000194, 7.3000000000000167},
                                         {24.000000000000068, 24.000000000000071},
                                         {24.00000000000005, 24.000000000000053},
                                         {0.50000000000001621, 0.50000000000001243},
                                         {8, 4},
                                         {4, 9},
                                         {15, 27},
                                         {26, 25},
                                         {19, 11}});
}

// T013, T014.
TEST(DelaunayAgainstCgal, kettners_grid_of_ulps_and_far_corners) {
  std::vector<Point> points{{12, 12}, {24, 24}, {-12, 30}, {30, -12}};
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) points.push_back({0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53});
  }
  expect_same_as_cgal(points);
}

// T012: pairs that other programs merge.
TEST(DelaunayAgainstCgal, pairs_of_any_small_distance) {
  Seeded seeded;
  for (const double apart : {1e-16, 1e-12, 1e-9, 1e-6}) {
    std::vector<Point> points;
    for (const Point p : families::uniform(seeded, 50)) {
      points.push_back(p);
      points.push_back({p.x + apart, p.y});
      points.push_back({p.x, p.y - apart});
    }
    expect_same_as_cgal(points);
  }
}

// T017, T018: a lattice turned by any angle.
TEST(DelaunayAgainstCgal, turned_lattices) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20); ++round)
    expect_same_as_cgal(families::lattice(400, 1, {0, 0}, seeded.uniform(0, 7)));
}

// T028, a tenth of it: no family takes long.
TEST(DelaunayAgainstCgal, large_sets) {
  Seeded seeded;
  expect_same_as_cgal(families::uniform(seeded, 100000));
  expect_same_as_cgal(families::clustered(seeded, 100000, 2, 1e-6));
  expect_same_as_cgal(families::rounded_circle(10000, {0, 0}, 1));
  expect_same_as_cgal(families::line(10000, {0, 0}, {0.1, 0.1}));
}

}  // namespace
}  // namespace thiessen
