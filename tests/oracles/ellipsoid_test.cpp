// Areas and cells on the ellipsoid, against GeographicLib: PolygonArea on finely divided rings, and
// Karney's geodesic distances from points to every place.
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "basin/cell_clipper.h"
#include "basin/shapes.h"
#include "diagram/surface.h"
#include "earth/area/ellipsoid_area.h"
#include "earth/area/ellipsoid_surface.h"
#include "earth/cells/geodesic_diagram.h"
#include "geometry/predicates.h"
#include "geometry/seeded.h"
#include "oracles/earth_oracle.h"

namespace thiessen {
namespace {

using GeographicLib::Geodesic;

const Geodesic& earth() {
  return Geodesic::WGS84();
}

double our_ring_area(const Ring& ring, double reference) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    area -= area_under(ring[i], ring[(i + 1) % ring.size()], reference);
  return area;
}

TEST(EllipsoidAgainstGeographicLib, areas_of_rings) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(30); ++round) {
    const double size = std::pow(10, seeded.uniform(-3, 1));
    const Point centre{seeded.uniform(-179, 179), seeded.uniform(-80, 80)};
    Ring ring = shapes::star(seeded, centre, std::min(size, 89.9 - std::abs(centre.y)), 8);
    const double expected = earth_oracle::area(ring, 1e-11);
    // PolygonArea's own rounding, over thousands of edges, shows in rings of some metres.
    EXPECT_NEAR(our_ring_area(ring, centre.y), expected, 1e-9 * expected + 0.02) << size;
  }
}

TEST(EllipsoidAgainstGeographicLib, areas_of_rings_at_a_pole_and_across_the_antimeridian) {
  const Ring cap{{-60, 80}, {60, 80}, {60, 90}, {-60, 90}};
  const Ring across{{170, -10}, {190, -15}, {195, 20}, {171, 12}};
  for (const Ring& ring : {cap, across}) {
    const double expected = earth_oracle::area(ring, 1e-11);
    EXPECT_NEAR(our_ring_area(ring, 0), expected, 1e-9 * expected);
  }
}

// 510065621.724 km2: the ellipsoid's whole area, GeographicLib's documentation of Planimeter.
TEST(EllipsoidAgainstGeographicLib, area_of_the_whole_earth) {
  const Ring whole{{-180, -90}, {180, -90}, {180, 90}, {-180, 90}};
  EXPECT_NEAR(our_ring_area(whole, 0) * 1e-6, 510065621.724, 0.0005);
  EXPECT_NEAR(our_ring_area(whole, 0) / earth().EllipsoidArea(), 1, 1e-15);
}

bool is_within(const Ring& ring, Point p) {
  bool within = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    within = within != ((orientation(a, b, p) > 0) == (b.y > a.y));
  }
  return within;
}

std::vector<Point> network(Seeded& seeded, Point centre, double kilometres, std::size_t count) {
  std::vector<Point> places(count);
  for (Point& p : places) {
    p = earth_oracle::destination(centre, seeded.uniform(0, 360),
                                  500 * kilometres * std::sqrt(seeded.uniform(0, 1)));
  }
  return places;
}

double sum_of(const std::vector<CellShare>& shares) {
  double sum = 0;
  for (const CellShare& share : shares) sum += share.area;
  return sum;
}

/// Shares of a star, against a grid of points, for networks that span the Earth or none of it.
void expect_shares(const std::vector<Point>& places, const Ring& ring, double allowed) {
  SCOPED_TRACE(testing::Message() << places.size() << " places, ring from " << ring[0].x << " "
                                  << ring[0].y);
  const Basin basin = shapes::basin({{ring, {}}});
  const EllipsoidSurface surface;
  const Box box = shapes::box_of(basin.shape);
  const Diagram diagram = geodesic_diagram(places, box, 0.05, 1e-6, 2);
  CellClipper clipper(diagram, surface);
  const std::vector<CellShare> shares = clipper.shares(basin);
  const double whole = area_of(basin, surface);
  EXPECT_NEAR(sum_of(shares), whole, 1e-12 * whole);
  std::map<std::size_t, double> ours;
  for (const CellShare& share : shares) ours[index(share.place)] += share.area / whole;
  const earth_oracle::NearestPlace nearest(places);
  std::map<std::size_t, double> expected;
  double all = 0;
  constexpr int rows = 200;
  const double step = box.height() / rows;
  for (int row = 0; row < rows; ++row) {
    const double y = box.low.y + (row + 0.5) * step;
    const double strip = area_under({0, y + step / 2}, {1, y + step / 2}, y - step / 2);
    for (int column = 0; column < rows; ++column) {
      const Point p{box.low.x + (column + 0.5) * box.width() / rows, y};
      if (!is_within(ring, p)) continue;
      expected[nearest(p)] += strip;
      all += strip;
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_NEAR(ours[i], expected[i] / all, allowed) << "place " << i;
}

TEST(CellsOfFewPlaces, one_has_all) {
  Seeded seeded;
  for (const Point place : {Point{10, 50}, Point{180, 0}, Point{0, 90}, Point{0, -90}})
    expect_shares({place}, shapes::star(seeded, {12, 48}, 5, 12), 1e-12);
}

TEST(CellsOfFewPlaces, two) {
  Seeded seeded;
  expect_shares({{10, 50}, {14, 47}}, shapes::star(seeded, {12, 48}, 5, 12), 3e-3);
  expect_shares({{0, 90}, {14, 47}}, shapes::star(seeded, {12, 70}, 15, 12), 3e-3);
  expect_shares({{-100, -20}, {100, 30}}, shapes::star(seeded, {0, 0}, 60, 12), 3e-3);
  expect_shares({{0, 0}, {180, 0}}, shapes::star(seeded, {90, 0}, 60, 12), 3e-3);
}

// On one meridian, one parallel, the equator.
TEST(CellsOfFewPlaces, three_on_a_circle) {
  Seeded seeded;
  const Ring star = shapes::star(seeded, {12, 48}, 8, 12);
  expect_shares({{12, 44}, {12, 48}, {12, 53}}, star, 3e-3);
  expect_shares({{8, 48}, {12, 48}, {17, 48}}, star, 3e-3);
  expect_shares({{8, 0}, {12, 0}, {17, 0}}, star, 3e-3);
  expect_shares({{-60, 0}, {60, 0}, {180, 0}}, shapes::star(seeded, {10, 5}, 70, 20), 3e-3);
}

TEST(CellsOfFewPlaces, a_town_and_a_basin_on_another_continent) {
  Seeded seeded;
  std::vector<Point> places = network(seeded, {103.85, 1.3}, 20, 15);
  // So far away the ellipsoid's and the sphere's bisectors part by kilometres.
  expect_shares(places, shapes::star(seeded, {-60, -10}, 15, 20), 2e-2);
  expect_shares(places, shapes::star(seeded, {12, 48}, 8, 20), 2e-2);
}

TEST(CellsOfFewPlaces, at_a_pole_and_round_it) {
  Seeded seeded;
  std::vector<Point> places{{0, 90}};
  for (int i = 0; i < 12; ++i) places.push_back({-180 + 30.0 * (i + 1), 80});
  expect_shares(places, {{-180, 75}, {180, 75}, {180, 90}, {-180, 90}}, 5e-3);
  places.erase(places.begin());
  expect_shares(places, {{-180, 75}, {180, 75}, {180, 90}, {-180, 90}}, 5e-3);
  expect_shares(places, {{-50, 79}, {50, 79}, {50, 90}, {-50, 90}}, 3e-3);
}

TEST(CellsOfFewPlaces, the_whole_earth) {
  Seeded seeded;
  std::vector<Point> places(30);
  for (Point& p : places) p = {seeded.uniform(-180, 180), seeded.uniform(-89, 89)};
  expect_shares(places, {{-180, -90}, {180, -90}, {180, 90}, {-180, 90}}, 3e-3);
}

}  // namespace
}  // namespace thiessen
