// Cells on the ellipsoid against GeographicLib: Karney's distances from random points to the
// nearest place, PolygonArea of every cell; and GEOS as the judge of what is valid. With
// THIESSEN_ROUNDS=100, 100,000 points in each network. At 1 mm the edges of networks that span
// continents take millions of chords: those are run with --gtest_also_run_disabled_tests only.
#include <gtest/gtest.h>
#include <tuple>

#include <map>
#include <numeric>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "basin/cell_clipper.h"
#include "basin/shapes.h"
#include "earth/area/ellipsoid_area.h"
#include "earth/area/ellipsoid_surface.h"
#include "earth/cells/geodesic_diagram.h"
#include "earth/cells/geodesic_vertices.h"
#include "earth/sphere/sphere_tessellation.h"
#include "earth/yardstick.h"
#include "geometry/seeded.h"
#include "oracles/earth_oracle.h"
#include "oracles/geos.h"

namespace thiessen {
namespace {

struct Setting {
  const char* name;
  Point centre;
  double kilometres;  ///< across; 0: the whole Earth
  std::size_t places;
  bool is_basin_the_earth = false;
};

void PrintTo(const Setting& setting, std::ostream* out) {
  *out << setting.name;
}

const std::vector<Setting> regions = {
    {"equator_20", {30, 0}, 20, 60},        {"north_45_20", {7, 45}, 20, 60},
    {"north_45_500", {7, 45}, 500, 150},    {"north_68_500", {20, 68}, 500, 100},
    {"north_85_20", {0, 85}, 20, 60},       {"north_pole_20", {0, 90}, 20, 60},
    {"south_35_500", {150, -35}, 500, 100}, {"fiji_500", {180, -18}, 500, 60},
    {"fiji_20", {180, -17}, 20, 60},
};
const std::vector<Setting> continents = {
    {"equator_5000", {30, 0}, 5000, 100},  {"north_45_5000", {-100, 45}, 5000, 60},
    {"north_85_2000", {0, 85}, 2000, 60},  {"south_pole_5000", {0, -90}, 5000, 60},
    {"whole_earth", {0, 0}, 0, 120, true},
};
// Near their antipode the cells of a town's gauges hardly differ in distance.
const std::vector<Setting> towns = {
    {"town_of_3", {8, 47}, 20, 3, true},       {"town_of_7", {-108, 39}, 90, 7, true},
    {"town_of_30", {150, -35}, 20, 30, true},  {"town_at_the_equator", {100, 0.1}, 30, 12, true},
    {"town_at_a_pole", {0, 90}, 30, 12, true},
};

bool holds_pole(const Setting& s) {
  return std::abs(s.centre.y) + s.kilometres / 222 >= 89.9;
}

std::vector<Point> places_of(const Setting& s, Seeded& seeded) {
  std::vector<Point> places;
  if (holds_pole(s)) places.push_back({0, std::copysign(90, s.centre.y)});
  while (places.size() < s.places) {
    if (s.kilometres == 0) {
      places.push_back({seeded.uniform(-180, 180), seeded.uniform(-90, 90)});
    } else {
      places.push_back(earth_oracle::destination(
          s.centre, seeded.uniform(0, 360), 500 * s.kilometres * std::sqrt(seeded.uniform(0, 1))));
    }
  }
  for (Point& p : places) p.x = std::remainder(p.x, 360);
  return places;
}

/// A ring round the network, or the cap round its pole, or all there is.
Basin basin_of(const Setting& s, Seeded& seeded) {
  if (s.is_basin_the_earth) return shapes::basin({{shapes::rectangle({-180, -90}, {180, 90}), {}}});
  if (holds_pole(s)) {
    const double reach = 90 - std::abs(s.centre.y) + s.kilometres / 222;
    return s.centre.y > 0
               ? shapes::basin({{shapes::rectangle({-180, 90 - reach}, {180, 90}), {}}})
               : shapes::basin({{shapes::rectangle({-180, -90}, {180, reach - 90}), {}}});
  }
  Ring ring;
  for (int i = 0; i < 24; ++i) {
    ring.push_back(earth_oracle::destination(s.centre, -15.0 * i,
                                             500 * s.kilometres * seeded.uniform(0.6, 1)));
  }
  return shapes::basin({{ring, {}}});
}

class GeodesicCells : public testing::TestWithParam<std::tuple<Setting, double>> {
 protected:
  void SetUp() override {
    const Yardstick yardstick{Metric::geodesic, 1, tolerance_};
    const Diagram diagram = yardstick.diagram(places_, frame_, 2);
    cells_ = CellClipper(diagram, surface_).cells(basin_);
  }

  GeodesicCells()
      : setting_(std::get<0>(GetParam())),
        tolerance_(std::get<1>(GetParam())),
        places_(places_of(setting_, seeded_)),
        basin_(basin_of(setting_, seeded_)),
        frame_(shapes::box_of(basin_.shape)) {}

  /// In the frame; where a town has the Earth, half of them round its antipode.
  Point random_point() {
    if (setting_.is_basin_the_earth && setting_.kilometres > 0 && seeded_.below(2) == 0) {
      const Point antipode{std::remainder(setting_.centre.x + 180, 360), -setting_.centre.y};
      Point p = earth_oracle::destination(antipode, seeded_.uniform(0, 360),
                                          1e3 * std::pow(10, seeded_.uniform(0, 3)));
      p.x = std::remainder(p.x, 360);
      return p;
    }
    return {seeded_.uniform(frame_.low.x, frame_.high.x),
            seeded_.uniform(frame_.low.y, frame_.high.y)};
  }

  Seeded seeded_;
  Setting setting_;
  double tolerance_;
  std::vector<Point> places_;
  Basin basin_;
  Box frame_;
  EllipsoidSurface surface_;
  std::vector<ClippedCell> cells_;
};

TEST_P(GeodesicCells, hold_each_point_once_and_it_is_nearest_to_their_place) {
  std::vector<const MultiPolygon*> shapes;
  for (const ClippedCell& cell : cells_) shapes.push_back(&cell.shape);
  const earth_oracle::Holders holders(shapes);
  const earth_oracle::Holders basin({&basin_.shape});
  const earth_oracle::NearestPlace nearest(places_);
  std::uint64_t wrong = 0;
  for (std::uint64_t tried = 0; tried < Seeded::rounds(1000);) {
    const Point p = random_point();
    if (basin.of(p).empty()) continue;
    ++tried;
    const std::vector<std::size_t> found = holders.of(p);
    ASSERT_EQ(found.size(), 1u) << p.x << ' ' << p.y;
    const Point owner = places_[index(cells_[found[0]].place)];
    const double behind =
        earth_oracle::distance(p, owner) - earth_oracle::distance(p, places_[nearest(p)]);
    if (behind > 2 * tolerance_) ++wrong;
  }
  EXPECT_EQ(wrong, 0u);
}

TEST_P(GeodesicCells, have_areas_that_add_up_to_the_basin_s) {
  double sum = 0;
  for (const ClippedCell& cell : cells_) sum += cell.area;
  const double whole = area_of(basin_, surface_);
  EXPECT_NEAR(sum, whole, std::max(1e-6, 1e-12 * whole));
  if (setting_.is_basin_the_earth) {
    EXPECT_NEAR(sum * 1e-6, 510065621.724, 0.0005);
  }
}

// A cell's area is that inside its true edges, however coarsely these are drawn: it is compared
// with the area of a ring that is drawn finely. PolygonArea rounds some hundredths of a square
// metre for a ring of thousands of edges.
TEST_P(GeodesicCells, have_the_areas_inside_their_true_edges) {
  const bool is_town =
      setting_.kilometres > 0 && setting_.kilometres <= 100 && !setting_.is_basin_the_earth;
  const double fine = is_town ? 1e-5 : 1e-3;
  const Diagram diagram = Yardstick{Metric::geodesic, 1, fine}.drawn_diagram(places_, frame_, 2);
  const std::vector<ClippedCell> drawn = CellClipper(diagram, surface_).cells(basin_);
  ASSERT_EQ(drawn.size(), cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const double area = cells_[i].area;
    const double allowed = std::max(1e-9 * area, 0.1);
    EXPECT_NEAR(area, earth_oracle::area(drawn[i].shape, allowed),
                allowed + 4 * fine * std::sqrt(area))
        << index(cells_[i].place);
  }
}

TEST_P(GeodesicCells, are_valid_and_share_their_edges_vertex_for_vertex) {
  std::set<std::pair<Point, Point>> edges;
  const auto for_each_edge = [&](const auto& visit) {
    for (const ClippedCell& cell : cells_) {
      for (const Polygon& part : cell.shape) {
        const auto go_round = [&](const Ring& ring) {
          for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
        };
        go_round(part.outer);
        for (const Ring& hole : part.holes) go_round(hole);
      }
    }
  };
  for (const ClippedCell& cell : cells_)
    EXPECT_EQ(geos::reason_invalid(*geos::geometry_of(cell.shape)), "") << index(cell.place);
  for_each_edge(
      [&](Point a, Point b) { EXPECT_TRUE(edges.emplace(a, b).second) << a.x << ' ' << a.y; });
  // What has no neighbour is the basin's own boundary.
  double alone = 0;
  for_each_edge([&](Point a, Point b) {
    if (edges.count({b, a}) == 0) alone += std::hypot(b.x - a.x, b.y - a.y);
  });
  double perimeter = 0;
  const Ring& outer = basin_.shape[0].outer;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const Point a = outer[i];
    const Point b = outer[(i + 1) % outer.size()];
    perimeter += std::hypot(b.x - a.x, b.y - a.y);
  }
  EXPECT_NEAR(alone, perimeter, 1e-11 * perimeter);
}

std::string name_of(const testing::TestParamInfo<std::tuple<Setting, double>>& test) {
  return std::string(std::get<0>(test.param).name) + (std::get<1>(test.param) < 0.1 ? "_mm" : "");
}
INSTANTIATE_TEST_SUITE_P(Regions, GeodesicCells,
                         testing::Combine(testing::ValuesIn(regions), testing::Values(0.1, 0.001)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Continents, GeodesicCells,
                         testing::Combine(testing::ValuesIn(continents), testing::Values(0.1)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Towns, GeodesicCells,
                         testing::Combine(testing::ValuesIn(towns), testing::Values(0.1)), name_of);
INSTANTIATE_TEST_SUITE_P(DISABLED_Continents, GeodesicCells,
                         testing::Combine(testing::ValuesIn(continents), testing::Values(0.001)),
                         name_of);

class GeodesicVoronoiVertices : public testing::TestWithParam<Setting> {};

TEST_P(GeodesicVoronoiVertices, are_at_equal_distance_of_their_places) {
  Seeded seeded;
  const Setting& setting = GetParam();
  const std::vector<Point> places = places_of(setting, seeded);
  const SphereTessellation sphere(places);
  const GeodesicVertices vertices(sphere, places, shapes::box_of(basin_of(setting, seeded).shape),
                                  1e-6, 2);
  constexpr double antipodal = 19.9e6;
  std::size_t seen = 0;
  for (std::uint32_t t = 0; t < vertices.mesh().triangles(); ++t) {
    if (!vertices.is_near(t)) continue;
    std::vector<double> distances;
    for (const PlaceIndex p : vertices.mesh().corners(t))
      distances.push_back(earth_oracle::distance(places[index(p)], vertices.position(t)));
    const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
    if (*most > antipodal) continue;
    ++seen;
    EXPECT_LE(*most - *least, 1e-6) << vertices.position(t).x << ' ' << vertices.position(t).y;
    const earth_oracle::NearestPlace nearest(places);
    const Point first = places[nearest(vertices.position(t))];
    EXPECT_GE(earth_oracle::distance(first, vertices.position(t)), *least - 1e-6);
  }
  EXPECT_GT(seen, 50u);
}

std::string name_of_setting(const testing::TestParamInfo<Setting>& test) {
  return test.param.name;
}
INSTANTIATE_TEST_SUITE_P(Regions, GeodesicVoronoiVertices, testing::ValuesIn(regions),
                         name_of_setting);
INSTANTIATE_TEST_SUITE_P(Continents, GeodesicVoronoiVertices, testing::ValuesIn(continents),
                         name_of_setting);

// Where distances, right to 15 nanometres, do not tell where an edge is, no chord follows them.
TEST(GaugesOfOneMast, have_no_more_chords_than_their_distances_can_tell) {
  Box earth;
  for (const Point corner : {Point{-180, -90}, Point{180, 90}}) earth.take_in(corner);
  const std::vector<Point> places{{10, 47}, {10.00000001, 47.00000001}, {10.0000002, 47}};
  for (const std::size_t count : {std::size_t{2}, std::size_t{3}}) {
    const std::vector<Point> some(places.begin(),
                                  places.begin() + static_cast<std::ptrdiff_t>(count));
    const Diagram diagram = geodesic_diagram(some, earth, 0.0005, 1e-6, 1);
    EXPECT_LT(diagram.chords.size(), 2'000'000u);
    EXPECT_GT(diagram.chords.size(), 1000u);
  }
}

}  // namespace
}  // namespace thiessen
