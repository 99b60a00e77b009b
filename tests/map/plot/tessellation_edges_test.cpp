#include "map/plot/tessellation_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "map/plot/scene_vector.h"

namespace thiessen {
namespace {

template <int Dimension>
Tessellation<Dimension> tessellation_of(const std::vector<PositionIn<Dimension>>& points) {
  Tessellation<Dimension> tessellation;
  tessellation.add_all(points);
  return tessellation;
}

template <int Dimension>
SceneCoordinates<Dimension> scene_of(const Tessellation<Dimension>& tessellation) {
  CoordinatesIn<Dimension> equal;
  equal.fill(1);
  return {CoordinateRange<Dimension>(tessellation), equal};
}

template <int Dimension>
TessellationEdges<Dimension> edges_of(const std::vector<PositionIn<Dimension>>& points,
                                      double half) {
  const auto tessellation = tessellation_of<Dimension>(points);
  CoordinatesIn<Dimension> box;
  box.fill(half);
  return edges_in_box(tessellation, scene_of(tessellation), box);
}

/// The edges, each from its lesser end, in order.
template <int Dimension>
std::vector<std::array<CoordinatesIn<Dimension>, 2>> sorted(
    const std::vector<EdgeIn<Dimension>>& edges) {
  std::vector<std::array<CoordinatesIn<Dimension>, 2>> result;
  for (const auto& e : edges) result.push_back({std::min(e.from, e.to), std::max(e.from, e.to)});
  std::sort(result.begin(), result.end());
  return result;
}

/// Different edges, their ends rounded to a millionth.
template <int Dimension>
std::size_t count_different(const std::vector<EdgeIn<Dimension>>& edges) {
  std::set<std::array<CoordinatesIn<Dimension>, 2>> different;
  for (auto pair : sorted(edges)) {
    for (auto& end : pair) {
      for (double& c : end) c = std::round(c * 1e6) + 0.0;
    }
    different.insert(pair);
  }
  return different.size();
}

template <int Dimension>
double distance(const CoordinatesIn<Dimension>& a, const CoordinatesIn<Dimension>& b) {
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}

/// How many points are as near to the place as the nearest one, by looking at each.
template <int Dimension>
std::size_t count_nearest(const Tessellation<Dimension>& tessellation,
                          const SceneCoordinates<Dimension>& scene,
                          const CoordinatesIn<Dimension>& place) {
  std::vector<double> distances;
  tessellation.for_each_point([&](PointId p) {
    distances.push_back(distance<Dimension>(scene(tessellation.position(p)), place));
  });
  const double least = *std::min_element(distances.begin(), distances.end());
  return static_cast<std::size_t>(std::count_if(distances.begin(), distances.end(),
                                                [least](double d) { return d <= least + 1e-9; }));
}

std::vector<Point> random_points(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Point> points(count);
  for (Point& p : points) p = {coordinate(random), coordinate(random)};
  return points;
}

std::vector<SpacePoint> random_space_points(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  return points;
}

TEST(TessellationEdges, of_two_points_are_their_bisector_and_what_joins_them) {
  const auto edges =
      edges_of<2>({{1, 1}, {5, 1}}, 0.75);  // 4 units of the plane are 1 of the scene
  ASSERT_EQ(edges.voronoi.size(), 1u);
  EXPECT_EQ(sorted(edges.voronoi)[0], (std::array<CoordinatesIn<2>, 2>{{{0, -0.75}, {0, 0.75}}}));
  ASSERT_EQ(edges.delaunay.size(), 1u);
  EXPECT_EQ(edges.delaunay[0].from, (CoordinatesIn<2>{-0.5, 0}));
  EXPECT_EQ(edges.delaunay[0].to, (CoordinatesIn<2>{0.5, 0}));
}

TEST(TessellationEdges, of_a_triangle_meet_in_its_centre) {
  const auto edges = edges_of<2>({{0, 0}, {4, 0}, {2, 4}}, 1);  // the centre is (2, 1.5)
  ASSERT_EQ(edges.voronoi.size(), 3u);
  for (const auto& edge : edges.voronoi) {
    const CoordinatesIn<2> centre{0, -0.125};
    EXPECT_TRUE(edge.from == centre || edge.to == centre);
  }
  EXPECT_EQ(edges.delaunay.size(), 3u);
}

TEST(TessellationEdges, of_a_tie_are_drawn_for_delaunay_and_not_for_voronoi) {
  const auto square = edges_of<2>({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, 1);
  EXPECT_EQ(square.voronoi.size(), 4u);
  EXPECT_EQ(square.delaunay.size(), 5u);
  std::vector<Point> lattice;
  for (int i = 0; i < 9; ++i) lattice.push_back({i % 3 * 1.0, i / 3 * 1.0});
  EXPECT_EQ(edges_of<2>(lattice, 1).voronoi.size(), 12u);
  EXPECT_EQ(edges_of<2>(lattice, 1).delaunay.size(), 16u);
}

TEST(TessellationEdges, of_points_on_a_line_are_parallel_and_the_line_itself) {
  const auto edges = edges_of<2>({{0, 0}, {1, 1}, {3, 3}, {4, 4}}, 2);
  ASSERT_EQ(edges.voronoi.size(), 3u);
  for (const auto& edge : edges.voronoi) {
    EXPECT_NEAR(edge.from[0] + edge.from[1], edge.to[0] + edge.to[1], 1e-15);
  }
  ASSERT_EQ(edges.delaunay.size(), 3u);
  for (const auto& edge : edges.delaunay) EXPECT_EQ(edge.from[0], edge.from[1]);
  EXPECT_TRUE(edges_of<2>({{7, 8}}, 1).delaunay.empty());
}

TEST(TessellationEdges, have_two_nearest_points_all_along) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto tessellation = tessellation_of<2>(random_points(60, seed));
    const auto scene = scene_of(tessellation);
    const auto edges = edges_in_box(tessellation, scene, {0.7, 0.6});
    for (const auto& e : edges.voronoi) {
      EXPECT_TRUE(std::abs(e.from[0]) <= 0.7 && std::abs(e.from[1]) <= 0.6) << seed;
      EXPECT_TRUE(std::abs(e.to[0]) <= 0.7 && std::abs(e.to[1]) <= 0.6) << seed;
      for (const double t : {0.0, 0.3, 1.0}) {
        const CoordinatesIn<2> place{e.from[0] + t * (e.to[0] - e.from[0]),
                                     e.from[1] + t * (e.to[1] - e.from[1])};
        EXPECT_GE(count_nearest(tessellation, scene, place), 2u) << "seed " << seed;
      }
    }
  }
}

TEST(TessellationEdges, are_as_many_of_voronoi_as_of_delaunay_where_there_is_no_tie) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const auto edges = edges_of<2>(random_points(200, seed), 1e7);
    EXPECT_EQ(edges.voronoi.size(), edges.delaunay.size()) << "seed " << seed;
  }
}

TEST(TessellationEdges, do_not_depend_on_the_order_of_the_points) {
  std::vector<Point> points = random_points(50, 3);
  for (int i = 0; i < 25; ++i) points.push_back({i % 5 / 4.0, i / 5 / 4.0});
  const auto before = edges_of<2>(points, 0.6);
  std::shuffle(points.begin(), points.end(), std::mt19937_64(1));
  Tessellation<2> tessellation;
  for (const Point p : points) tessellation.add(p);
  tessellation.remove(tessellation.add({0.123, 0.456}));
  const auto after = edges_in_box(tessellation, scene_of(tessellation), {0.6, 0.6});
  EXPECT_EQ(sorted(after.voronoi), sorted(before.voronoi));
  EXPECT_EQ(sorted(after.delaunay), sorted(before.delaunay));
}

TEST(TessellationEdges, keep_all_their_digits_far_from_the_origin) {
  std::vector<Point> near{{0, 0}};
  std::mt19937_64 random(7);
  for (int i = 0; i < 20; ++i) {
    near.push_back({static_cast<double>(random() % 64) * 0x1p-30,
                    static_cast<double>(random() % 64) * 0x1p-30});
  }
  std::vector<Point> far = near;
  for (Point& p : far) p = {p.x + 0x1p22, p.y + 0x1p22};  // exact: 30 bits are left
  const auto edges = edges_of<2>(far, 0.7);
  const auto expected = edges_of<2>(near, 0.7);
  EXPECT_EQ(sorted(edges.voronoi), sorted(expected.voronoi));
  EXPECT_EQ(sorted(edges.delaunay), sorted(expected.delaunay));
}

TEST(TessellationEdges, of_nearly_collinear_points_are_not_turned_by_far_vertices) {
  std::vector<Point> points;  // tenths: their doubles are on no line, the vertices 1e15 away
  for (int i = 0; i < 30; ++i) points.push_back({i / 10.0, i / 10.0 * 3});
  const auto tessellation = tessellation_of<2>(points);
  ASSERT_EQ(tessellation.span(), Span::plane);
  const auto scene = scene_of(tessellation);
  const auto edges = edges_in_box(tessellation, scene, {1, 1});
  EXPECT_GE(edges.voronoi.size(), 29u);
  for (const auto& e : edges.voronoi) {
    const double slope = (e.to[1] - e.from[1]) / (e.to[0] - e.from[0]);
    EXPECT_NEAR(slope, -1.0 / 3, 1e-9);
  }
}

TEST(TessellationEdges, of_a_tetrahedron_are_four_rays_from_its_centre) {
  const auto edges = edges_of<3>({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, 0.8);
  ASSERT_EQ(edges.voronoi.size(), 4u);
  std::vector<SpacePoint> ends;
  for (const auto& e : edges.voronoi) {
    const bool from_centre = length(e.from) == 0;
    EXPECT_TRUE(from_centre || length(e.to) == 0);
    const auto& end = from_centre ? e.to : e.from;
    ends.push_back({end[0] + 0.0, end[1] + 0.0, end[2] + 0.0});
  }
  std::sort(ends.begin(), ends.end());
  const std::vector<SpacePoint> expected{{-0.8, 0, 0}, {0, -0.8, 0}, {0, 0, -0.8}, {0.8, 0.8, 0.8}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(ends[i].x, expected[i].x, 1e-15);
    EXPECT_NEAR(ends[i].y, expected[i].y, 1e-15);
    EXPECT_NEAR(ends[i].z, expected[i].z, 1e-15);
  }
  EXPECT_EQ(edges.delaunay.size(), 6u);
}

TEST(TessellationEdges, of_a_cube_and_its_centre_are_an_octahedron_and_six_rays) {
  std::vector<SpacePoint> points{{1, 1, 1}};
  for (int i = 0; i < 8; ++i) points.push_back({i % 2 * 2.0, i / 2 % 2 * 2.0, i / 4 * 2.0});
  const auto edges = edges_of<3>(points, 2);
  EXPECT_EQ(count_different(edges.voronoi), 12u + 6u);
  EXPECT_EQ(edges.delaunay.size(), 12u + 8u + 6u) << "a diagonal for each face";
}

TEST(TessellationEdges, in_space_have_three_nearest_points_all_along) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto tessellation = tessellation_of<3>(random_space_points(40, seed));
    const auto scene = scene_of(tessellation);
    const auto edges = edges_in_box(tessellation, scene, {0.7, 0.6, 0.65});
    EXPECT_GT(edges.voronoi.size(), 100u);
    for (const auto& e : edges.voronoi) {
      EXPECT_GE(count_nearest(tessellation, scene, e.from), 3u) << "seed " << seed;
      EXPECT_GE(count_nearest(tessellation, scene, e.to), 3u) << "seed " << seed;
    }
    EXPECT_TRUE(edges.rims.empty());
  }
}

TEST(TessellationEdges, in_space_do_not_depend_on_the_order_of_the_points) {
  std::vector<SpacePoint> points = random_space_points(20, 5);
  for (int i = 0; i < 27; ++i) points.push_back({i % 3 / 2.0, i / 3 % 3 / 2.0, i / 9 / 2.0});
  const auto before = edges_of<3>(points, 0.6);
  std::shuffle(points.begin(), points.end(), std::mt19937_64(1));
  const auto after = edges_of<3>(points, 0.6);
  EXPECT_EQ(sorted(after.voronoi), sorted(before.voronoi));
  EXPECT_EQ(sorted(after.delaunay), sorted(before.delaunay));
}

TEST(TessellationEdges, of_points_of_a_plane_in_space_stand_upright_on_it) {
  const auto edges = edges_of<3>({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}}, 0.75);
  EXPECT_EQ(count_different(edges.voronoi), 1u);
  EXPECT_EQ(sorted(edges.voronoi)[0],
            (std::array<CoordinatesIn<3>, 2>{{{0, 0, -0.75}, {0, 0, 0.75}}}));
  EXPECT_EQ(edges.delaunay.size(), 5u);
  EXPECT_EQ(count_different(edges.rims), 4u * 3u) << "four walls, open towards the middle";
}

TEST(TessellationEdges, of_two_points_in_space_are_the_rim_of_a_wall) {
  const auto edges = edges_of<3>({{0, 1, 2}, {2, 1, 2}}, 0.75);
  EXPECT_TRUE(edges.voronoi.empty());
  EXPECT_EQ(edges.delaunay.size(), 1u);
  ASSERT_EQ(edges.rims.size(), 4u);
  for (const auto& e : edges.rims) {
    EXPECT_NEAR(e.from[0], 0, 1e-15);
    EXPECT_NEAR(e.to[0], 0, 1e-15);
    EXPECT_NEAR(distance<3>(e.from, e.to), 1.5, 1e-12);
  }
}

}  // namespace
}  // namespace thiessen
