// The tessellation of space against CGAL's Delaunay triangulation of the same points (T031).
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "oracles/same_as_cgal.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

void expect_same_as_cgal(const std::vector<SpacePoint>& points) {
  expect_sound_and_same_as_cgal<3>(points);
}

TEST(DelaunayInSpaceAgainstCgal, every_family) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2); ++round) {
    for (const std::size_t count : {5u, 20u, 150u, 1000u}) {
      for (const FamilyIn<3>& family : families::all_in<3>(seeded, count)) {
        SCOPED_TRACE(family.name);
        expect_same_as_cgal(family.points);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(DelaunayInSpaceAgainstCgal, thousands_of_small_degenerate_sets) {
  Seeded seeded;
  const std::vector<SpacePoint> sphere = families::whole_sphere(29, {0, 0, 0});
  for (std::uint64_t round = 0; round < seeded.rounds(4000); ++round) {
    const std::size_t count = 4 + seeded.below(16);
    std::vector<SpacePoint> points =
        families::small_grid_in_space(seeded, count, seeded.whole(1, 3));
    if (round % 4 == 1) points = families::ulp_cluster_in_space(seeded, count, {0.1, 4e6, -70}, 2);
    if (round % 4 == 2) {
      points = sphere;
      std::shuffle(points.begin(), points.end(), seeded.generator());
      points.resize(count);
    }
    if (round % 4 == 3) {  // flat but for one or two
      for (std::size_t i = 2; i < points.size(); ++i) points[i].z = points[i].x - points[i].y;
    }
    expect_same_as_cgal(points);
    if (testing::Test::HasFailure()) return;
  }
}

// T031: ten to the third.
TEST(DelaunayInSpaceAgainstCgal, a_cubic_lattice_of_a_thousand) {
  for (const SpacePoint& origin : {SpacePoint{0, 0, 0}, SpacePoint{500000, 4000000, 1000}}) {
    for (const double step : {1.0, 0.1}) {
      for (const double angle : {0.0, 0.3})
        expect_same_as_cgal(families::lattice_in_space(1000, step, origin, angle));
    }
  }
}

TEST(DelaunayInSpaceAgainstCgal, large_sets) {
  Seeded seeded;
  expect_same_as_cgal(families::uniform_in_space(seeded, 20000));
  expect_same_as_cgal(families::clustered_in_space(seeded, 10000, 2, 1e-6));
  expect_same_as_cgal(families::rounded_sphere(seeded, 3000, {0, 0, 0}, 1));
  expect_same_as_cgal(families::line_in_space(2000, {0, 0, 0}, {0.1, 0.1, 0.7}));
}

}  // namespace
}  // namespace thiessen
