// The triangles and the borders of places in a plane against CGAL's Delaunay triangulation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "diagram/plane_dual.h"
#include "geometry/predicates.h"
#include "oracles/delaunay_complex.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

using Corners = std::array<Point, 3>;

Corners sorted(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Whether CGAL's triangle is the only one there: no fourth point is on its circle.
bool is_sure(const cgal::Division<2>& division, const cgal::Division<2>::Simplex& simplex) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (simplex.across[i] == cgal::Division<2>::none) continue;
    for (const Point q : division.simplices[simplex.across[i]].corners) {
      const auto& c = simplex.corners;
      const bool is_corner = q == c[0] || q == c[1] || q == c[2];
      if (!is_corner && cgal::side_of_sphere<2>(2, simplex, q) == 0) return false;
    }
  }
  return true;
}

void expect_same_as_cgal(std::vector<Point> places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const Dual dual = plane_dual(places);
  const auto division =
      cgal::division_of(cgal::triangulation_of<2>(std::span<const Point>(places)));
  std::set<Corners> ours;
  for (const DualTriangle& t : dual.triangles) {
    const Corners corners{places[index(t[0])], places[index(t[1])], places[index(t[2])]};
    ASSERT_GT(orientation(corners[0], corners[1], corners[2]), 0) << "counter-clockwise";
    ours.insert(sorted(corners));
  }
  if (division.dimension < 2) {
    EXPECT_TRUE(ours.empty());
    return;
  }
  ASSERT_EQ(ours.size(), dual.triangles.size());
  ASSERT_EQ(ours.size(), division.simplices.size());
  std::set<std::pair<Point, Point>> bordering;
  for (const Border& border : dual.borders) {
    EXPECT_GT(border.length, 0);
    bordering.insert(std::minmax(places[index(border.first)], places[index(border.second)]));
  }
  for (const auto& simplex : division.simplices) {
    if (!is_sure(division, simplex)) continue;
    ASSERT_TRUE(ours.contains(sorted(simplex.corners)));
  }
  // A side of our triangles that has no border is one across which cells only touch.
  for (const DualTriangle& t : dual.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto side = std::minmax(places[index(t.at(i))], places[index(t.at((i + 1) % 3))]);
      if (bordering.contains(side)) bordering.erase(side);
    }
  }
  EXPECT_TRUE(bordering.empty()) << "each border belongs to a side of triangles";
}

TEST(DelaunayOfPlaces, every_family) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(3); ++round) {
    for (const std::size_t count : {5u, 20u, 150u, 1000u}) {
      for (const Family& family : families::all_in<2>(seeded, count)) {
        SCOPED_TRACE(family.name);
        expect_same_as_cgal(family.points);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

TEST(DelaunayOfPlaces, thousands_of_small_degenerate_sets) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(3000); ++round) {
    const std::size_t count = 3 + seeded.below(12);
    std::vector<Point> points = families::small_grid(seeded, count, 1 + seeded.whole(0, 3));
    if (round % 3 == 1) points = families::ulp_cluster(seeded, count, {0.1, 4e6}, 2);
    expect_same_as_cgal(points);
    if (testing::Test::HasFailure()) return;
  }
}

// Lengths against the distance between CGAL's circumcentres, where that is a good judge.
TEST(DelaunayOfPlaces, borders_are_as_long_as_cgal_has_them) {
  Seeded seeded;
  const std::vector<Point> places = families::uniform(seeded, 2000);
  std::map<std::pair<Point, Point>, double> lengths;
  for (const Border& border : plane_dual(places).borders)
    lengths[std::minmax(places[index(border.first)], places[index(border.second)])] = border.length;
  const auto triangulation = cgal::triangulation_of<2>(std::span<const Point>(places));
  std::size_t compared = 0;
  for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e) {
    const auto face = e->first;
    const Point a = cgal::ours(face->vertex(triangulation.cw(e->second))->point());
    const Point b = cgal::ours(face->vertex(triangulation.ccw(e->second))->point());
    const double length = lengths.at(std::minmax(a, b));
    const bool is_on_hull =
        triangulation.is_infinite(face) || triangulation.is_infinite(face->neighbor(e->second));
    ASSERT_EQ(std::isinf(length), is_on_hull);
    if (is_on_hull) continue;
    const auto p = triangulation.circumcenter(face);
    const auto q = triangulation.circumcenter(face->neighbor(e->second));
    const double apart = std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
    if (apart > 10) continue;
    EXPECT_NEAR(length, apart, 1e-9 * (1 + apart));
    ++compared;
  }
  EXPECT_GT(compared, 5000U);
}

}  // namespace
}  // namespace thiessen
