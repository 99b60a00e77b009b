#include "basin/sphere_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "basin/cell_clipper.h"
#include "basin/shapes.h"
#include "earth/area/ellipsoid_surface.h"
#include "earth/cells/chart_diagram.h"
#include "earth/cells/geodesic_diagram.h"
#include "earth/sphere/conformal_sphere.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double tolerance = 0.1;

Point random_centre(Seeded& seeded) {
  return {seeded.uniform(-180, 180), seeded.uniform(-75, 75)};
}

double area_in_chart(const SphereShape& shape, Direction centre) {
  const GnomonicChart chart(centre);
  return area_of(shape.in_chart(chart), ChartSurface(chart));
}

// Sides of 400 km along a parallel are 2 km off the great circle in their middle.
TEST(SphereShape, has_the_ground_s_area_in_any_chart) {
  Seeded seeded;
  const EllipsoidSurface ellipsoid;
  for (std::uint64_t i = 0; i < Seeded::rounds(200); ++i) {
    const Point centre = random_centre(seeded);
    const double size = std::pow(10, seeded.uniform(-3, 0.5));  // degrees
    Basin basin = shapes::basin({{shapes::star(seeded, centre, size, 12), {}}});
    basin.shape[0].holes.push_back(
        shapes::reversed(shapes::scaled(basin.shape[0].outer, centre, 0.2)));
    const SphereShape shape(basin, {}, tolerance);
    const double area = area_of(basin, ellipsoid);
    EXPECT_NEAR(area_in_chart(shape, shape.centre()), area, 1e-8 * area);
    const Direction elsewhere = on_sphere({centre.x + size, centre.y - size / 2});
    EXPECT_NEAR(area_in_chart(shape, elsewhere), area, 1e-7 * area);
  }
}

// Corners that only bend a side may go: their areas stay.
TEST(SphereShape, leaves_bends_out_and_keeps_their_area) {
  Seeded seeded;
  const EllipsoidSurface ellipsoid;
  for (std::uint64_t i = 0; i < Seeded::rounds(200); ++i) {
    const Point centre = random_centre(seeded);
    const Ring corners = shapes::star(seeded, centre, 1e-3, 7);  // so that sides are not parted
    Ring ring;
    std::vector<Point> bends;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const Point a = corners[c];
      const Point b = corners[(c + 1) % corners.size()];
      ring.push_back(a);
      for (int piece = 1; piece < 4; ++piece) {
        const double off = seeded.uniform(-1e-6, 1e-6);
        bends.push_back({a.x + piece * (b.x - a.x) / 4 - off * (b.y - a.y),
                         a.y + piece * (b.y - a.y) / 4 + off * (b.x - a.x)});
        ring.push_back(bends.back());
      }
    }
    std::sort(bends.begin(), bends.end());
    const Basin basin = shapes::basin({{ring, {}}});
    const SphereShape shape(basin, bends, tolerance);
    const GnomonicChart chart(shape.centre());
    EXPECT_EQ(shape.in_chart(chart).shape[0].outer.size(), corners.size());
    const double area = area_of(basin, ellipsoid);
    EXPECT_NEAR(area_in_chart(shape, shape.centre()), area, 1e-8 * area);
  }
}

TEST(SphereShape, keeps_its_corners_where_all_are_bends) {
  const Ring ring = shapes::rectangle({10, 50}, {10.001, 50.001});
  std::vector<Point> bends = ring;
  std::sort(bends.begin(), bends.end());
  const SphereShape shape(shapes::basin({{ring, {}}}), bends, tolerance);
  EXPECT_EQ(shape.in_chart(GnomonicChart(shape.centre())).shape[0].outer.size(), 4u);
}

// The bulges of a projected basin's edges are parted where an edge is.
TEST(SphereShape, keeps_the_bulges_of_the_basin_s_edges) {
  Basin basin = shapes::basin({{shapes::rectangle({10, 50}, {13, 52}), {}}});
  basin.bulges = {{1e6, -2e6, 3e6, 4e6}};
  const SphereShape shape(basin, {}, tolerance);
  const double area = area_of(basin, EllipsoidSurface());
  EXPECT_NEAR(area_in_chart(shape, shape.centre()), area, 1e-8 * area);
}

TEST(SphereShape, keeps_nothing_of_what_is_too_large_for_a_chart) {
  const SphereShape half(shapes::basin({{shapes::rectangle({-180, 0}, {180, 90}), {}}}), {},
                         tolerance);
  EXPECT_GT(half.reach(), SphereShape::farthest_reach);
  EXPECT_TRUE(half.in_chart(GnomonicChart(half.centre())).shape.empty());
}

// The parts that cells cut off it are those of the cells in longitude and latitude.
TEST(SphereShape, is_cut_as_the_ground_is) {
  Seeded seeded;
  const EllipsoidSurface ellipsoid;
  for (std::uint64_t i = 0; i < Seeded::rounds(50); ++i) {
    const Point centre = random_centre(seeded);
    const double size = std::pow(10, seeded.uniform(-2, 0));
    std::vector<Point> places;
    for (int p = 0; p < 8; ++p) {
      places.push_back(
          {centre.x + seeded.uniform(-2, 2) * size, centre.y + seeded.uniform(-2, 2) * size});
    }
    const Basin basin = shapes::basin({{shapes::star(seeded, centre, size, 9), {}}});
    const SphereShape shape(basin, {}, tolerance);
    const GnomonicChart chart(shape.centre());
    const auto in_chart =
        chart_diagram(places, {chart, 1.1 * shape.reach(), shape.box()}, {1e-5, tolerance});
    if (!in_chart) continue;
    const ChartSurface surface(chart);
    CellClipper chart_clipper(*in_chart, surface);
    const auto found = chart_clipper.shares(shape.in_chart(chart));
    const Diagram diagram = geodesic_diagram(places, shape.box(), 1e-3 * size, 1e-6, 1);
    CellClipper clipper(diagram, ellipsoid);
    const auto expected = clipper.shares(basin);
    const double area = area_of(basin, ellipsoid);
    std::vector<double> difference(places.size());
    for (const CellShare& share : expected) difference[index(share.place)] += share.area;
    for (const CellShare& share : found) difference[index(share.place)] -= share.area;
    for (const double off : difference)
      EXPECT_NEAR(off / area, 0, 1e-6 * tolerance / size + 1e-8) << size;
  }
}

}  // namespace
}  // namespace thiessen
