#include "files/study_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "earth/area/ellipsoid_area.h"
#include "outlines/ellipsoid_strip.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

/// A study of two small files.
struct Given {
  std::string stations = "id,lon,lat\na,15,50\nb,16,51\n";
  std::string basins = R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
    "geometry":{"type":"Polygon","coordinates":[[[15,50],[16,50],[16,51],[15,51],[15,50]]]}}]})";
  std::string basins_name = "b.geojson";
  StudyRequest request = {};
  bool with_basins = true;
  Warnings warnings = {};

  StudyFiles study() {
    const TemporaryFolder folder;
    request.stations.source.file = folder.write("s.csv", stations);
    if (with_basins) {
      if (!request.basins) request.basins.emplace();
      request.basins->source.file = folder.write(basins_name, basins);
      request.basins->source.crs_setting = "basins_crs";
    }
    return read_study(request, warnings);
  }
  std::string warning(std::size_t i) const { return sentences_of(warnings).at(i); }
};

/// A square in a CSV, whose CRS is only what the options say.
std::string square(double x, double y, double side) {
  const auto at = [&](double u, double v) {
    return std::to_string(x + u * side) + " " + std::to_string(y + v * side);
  };
  return "id,WKT\nq,\"POLYGON ((" + at(0, 0) + "," + at(1, 0) + "," + at(1, 1) + "," + at(0, 1) +
         "," + at(0, 0) + "))\"\n";
}

std::string geojson(const std::string& ring) {
  return R"({"type":"Polygon","coordinates":[)" + ring + "]}";
}

TEST(Study, is_read_by_two_threads_as_by_one) {
  const auto read = [](unsigned threads, const std::string& stations, const std::string& basins) {
    Given given;
    given.stations = stations;
    given.basins = basins;
    given.basins_name = "b.csv";
    given.request.threads = threads;
    const StudyFiles study = given.study();
    std::vector<std::string> told;  // without the folder, which is another each time
    for (const std::string& text : sentences_of(given.warnings))
      told.push_back(text.substr(text.find(".csv")));
    return std::tuple(study.stations.size(), study.basins.at(0).shape.at(0).outer, told);
  };
  const std::string stations = "id,x,y\na,1000,2000\nb,3000,4000\n";
  const std::string open = "id,WKT\nq,\"POLYGON ((0 0,4000 0,4000 4000,0 4000))\"\n";
  EXPECT_EQ(std::get<2>(read(2, stations, open)).at(0), ".csv:2: basin 'q' is mended: 1 open ring");
  EXPECT_EQ(read(2, stations, open), read(1, stations, open));
  // Faults of the stations are told first, and alone.
  const auto faulty_file = [&](const std::string& of_stations) {
    const auto faults = complaints_of([&] { read(2, of_stations, "id,WKT\nq,POINT\n"); });
    return faults.size() == 1 ? faults[0].substr(faults[0].find(".csv") - 1, 5) : "";
  };
  EXPECT_EQ(faulty_file("id,x,y\na,1,x\n"), "s.csv");
  EXPECT_EQ(faulty_file(stations), "b.csv");
}

TEST(Study, longitude_and_latitude_are_geodesic) {
  Given given;
  const StudyFiles study = given.study();
  EXPECT_EQ(study.metric, Metric::geodesic);
  EXPECT_TRUE(study.crs->is_wgs84());
  EXPECT_EQ(study.stations.at(1).position, (Point{16, 51}));
  EXPECT_EQ(study.basins.at(0).shape.at(0).outer.size(), 4U);
  EXPECT_TRUE(study.basins.at(0).bulges.empty());
  EXPECT_FALSE(study.metres_per_unit);
  EXPECT_TRUE(given.warnings.messages().empty());
}

TEST(Study, a_plane_without_crs_is_planar_and_silent_where_it_is_asked_for) {
  Given given;
  given.stations = "id,x,y\na,7,4\n";
  given.basins = square(0, 0, 9);
  given.basins_name = "b.csv";
  given.request.metric = Metric::planar;
  const StudyFiles study = given.study();
  EXPECT_EQ(study.metric, Metric::planar);
  EXPECT_FALSE(study.crs);
  EXPECT_FALSE(study.metres_per_unit);
  EXPECT_EQ(study.stations.at(0).position, (Point{7, 4}));
  EXPECT_TRUE(given.warnings.messages().empty());
}

TEST(Study, a_crs_that_one_side_names_holds_for_both) {
  Given given;
  given.stations = "id,x,y\na,500000,5500000\n";
  given.basins = square(499000, 5499000, 2000);
  given.basins_name = "b.csv";
  given.request.stations.source.crs = "EPSG:32633";
  const StudyFiles study = given.study();
  EXPECT_EQ(study.metric, Metric::geodesic);
  EXPECT_EQ(study.basins_crs->name(), "EPSG:32633");
  ASSERT_EQ(given.warnings.messages().size(), 1U);
  EXPECT_TRUE(contains(given.warning(0), "names no CRS"));
  EXPECT_NEAR(study.stations.at(0).position.x, 15, 1e-12);
}

TEST(Study, a_crs_lent_to_geojson_in_metres) {
  Given given;
  given.stations = "id,x,y\na,500000,5500000\n";
  given.basins = geojson("[[499000,5499000],[501000,5499000],[501000,5501000],[499000,5499000]]");
  given.request.stations.source.crs = "EPSG:32633";
  EXPECT_EQ(given.study().basins_crs->name(), "EPSG:32633");
  EXPECT_EQ(given.warnings.messages().size(), 1U);
}

TEST(Study, projected_edges_are_followed_over_the_ellipsoid) {
  Given given;
  given.stations = "id,x,y\na,620000,5600000\n";
  given.basins = square(600000, 5500000, 100000);
  given.basins_name = "b.csv";
  given.request.stations.source.crs = "EPSG:32633";
  const StudyFiles study = given.study();
  const Ring& ring = study.basins.at(0).shape.at(0).outer;
  const std::vector<double>& bulges = study.basins.at(0).bulges.at(0);
  ASSERT_EQ(bulges.size(), ring.size());
  EXPECT_GT(ring.size(), 100U);
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    area -= area_under(ring[i], ring[(i + 1) % ring.size()], 50);
    area += bulges[i];
  }
  // The plane's area over the square of the scale factor, by Simpson's rule over the square's
  // columns: transverse Mercator has k = k0 (1 + u^2/2 + u^4/24) with u = (x - 500000) / (k0 R),
  // R^2 = M N at latitude 50 (its change over the square and higher terms leave 2e-7).
  const double k0 = 0.9996;
  const double e2 = 0.00669437999014;
  const double s2 = std::pow(std::sin(50.1 * std::acos(-1.0) / 180), 2);
  const double radius2 = 6378137.0 * 6378137.0 * (1 - e2) / ((1 - e2 * s2) * (1 - e2 * s2));
  const auto inverse_square = [&](double x) {
    const double u2 = (x - 500000) * (x - 500000) / (k0 * k0 * radius2);
    const double k = k0 * (1 + u2 / 2 + u2 * u2 / 24);
    return 1 / (k * k);
  };
  const double mean =
      (inverse_square(600000) + 4 * inverse_square(650000) + inverse_square(700000)) / 6;
  EXPECT_NEAR(area / (1e10 * mean), 1, 1e-6);
}

TEST(Study, a_finer_tolerance_changes_the_vertices_and_not_the_area) {
  double areas[2] = {};
  std::size_t vertices[2] = {};
  for (int fine = 0; fine < 2; ++fine) {
    Given given;
    given.stations = "id,x,y\na,620000,5600000\n";
    given.basins = square(600000, 5500000, 100000);
    given.basins_name = "b.csv";
    given.request.stations.source.crs = "EPSG:32633";
    given.request.tolerance = fine == 1 ? 0.001 : 10;
    const StudyFiles study = given.study();
    const Ring& ring = study.basins.at(0).shape.at(0).outer;
    vertices[fine] = study.drawn_basins.at(0).shape.at(0).outer.size();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      areas[fine] -= area_under(ring[i], ring[(i + 1) % ring.size()], 50);
      areas[fine] += study.basins.at(0).bulges.at(0)[i];
    }
  }
  EXPECT_GT(vertices[1], 10 * vertices[0]);
  EXPECT_NEAR(areas[0] / areas[1], 1, 1e-11);
}

TEST(Study, the_plane_option_takes_vertices_alone) {
  Given given;
  given.request.plane = "EPSG:32633";
  const StudyFiles study = given.study();
  EXPECT_EQ(study.metric, Metric::planar);
  EXPECT_EQ(study.crs->name(), "EPSG:32633");
  EXPECT_EQ(study.metres_per_unit, 1);
  EXPECT_EQ(study.basins.at(0).shape.at(0).outer.size(), 4U);
  EXPECT_TRUE(study.basins.at(0).bulges.empty());
  EXPECT_NEAR(study.stations.at(0).position.x, 500000, 1e-6);
  EXPECT_GT(study.stations.at(0).position.y, 5.5e6);
  EXPECT_TRUE(study.basins_crs->is_wgs84());
}

TEST(Study, the_plane_option_joins_what_the_antimeridian_cuts) {
  Given given;
  given.stations = "id,lon,lat\na,10,-70\nb,20,-75\n";
  given.request.plane = "EPSG:3031";
  // Round the pole, and over the antimeridian beside it; the latter with a vertex of its own there.
  for (const char* ring : {"[[-135,-80],[-45,-80],[45,-80],[135,-80],[225,-80],[-135,-80]]",
                           "[[170,-80],[170,-70],[180,-70],[-170,-80],[170,-80]]"}) {
    given.basins = geojson(ring);
    const StudyFiles study = given.study();
    ASSERT_EQ(study.basins.at(0).shape.size(), 1U);
    EXPECT_EQ(study.basins.at(0).shape.at(0).outer.size(), 4U);
    EXPECT_TRUE(study.basins.at(0).shape.at(0).holes.empty());
  }
}

TEST(Study, a_plane_without_the_pole_that_a_basin_holds_is_told) {
  Given given;
  given.request.plane = "EPSG:3857";
  given.basins = geojson("[[-135,80],[-45,80],[45,80],[135,80],[180,80],[-135,80]]");
  EXPECT_TRUE(contains(complaint_of([&] { given.study(); }),
                       "the point 0 90 lies outside the projection's area (EPSG:3857)"));
}

TEST(Study, basins_all_round_the_earth_in_a_projection) {
  Given given;
  given.stations = "id,lon,lat\na,10,70\n";
  given.basins_name = "b.csv";
  given.request.basins.emplace();
  given.request.basins->source.crs = "EPSG:3571";
  const auto square_at = [](const std::string& id, double x, double y) {
    return id + square(x, y, 2e6).substr(std::string("id,WKT\nq").size());
  };
  // Round the pole, and over the antimeridian, which leads to the left there.
  given.basins = "id,WKT\n" + square_at("pole", -1e6, -1e6) + square_at("beside", 1e6, -1e6) +
                 square_at("left", -3e6, -1e6) + square_at("below", -1e6, -3e6) +
                 square_at("above", -1e6, 1e6);
  const StudyFiles study = given.study();
  ASSERT_EQ(study.basins.size(), 5U);
  for (const Basin& basin : study.basins) {
    for (const Polygon& part : basin.shape) {
      for (const Point point : part.outer) EXPECT_LE(std::abs(point.x), 180);
    }
    // The plane has equal areas; PROJ's series leaves 1e-10.
    EXPECT_NEAR(area_on_earth({basin.shape, basin.bulges}) / 4e12, 1, 1e-9) << basin.id;
  }
}

TEST(Study, planar_on_degrees_warns_with_a_figure) {
  Given given;
  given.stations = "id,lon,lat\na,15,60\nb,16,60\n";
  given.request.metric = Metric::planar;
  EXPECT_EQ(given.study().metric, Metric::planar);
  // cos 60 = 0.5
  EXPECT_TRUE(
      contains(given.warning(0), "at latitude 60.0 a degree from west to east is 50.0 % shorter"));
}

TEST(Study, geodesic_needs_a_crs) {
  Given given;
  given.stations = "id,x,y\na,7,4\n";
  given.basins = square(0, 0, 9);
  given.basins_name = "b.csv";
  given.request.metric = Metric::geodesic;
  EXPECT_TRUE(
      contains(complaint_of([&] { given.study(); }), "metric = geodesic needs to know the CRS"));
  given.request.metric.reset();
  given.request.plane = "EPSG:32633";
  EXPECT_TRUE(contains(complaint_of([&] { given.study(); }), "'plane' needs to know the CRS"));
}

TEST(Study, latitudes_beyond_the_poles_look_swapped) {
  Given given;
  given.stations = "id,lon,lat\na,35,132.5\nb,15,50\nc,36,-133\n";
  auto found = complaints_of([&] { given.study(); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(contains(
      found[0],
      "s.csv:2: latitude 132.5 of station 'a' is outside [-90, 90] | columns look swapped"));
  EXPECT_TRUE(found[1].ends_with("s.csv:4: latitude -133 of station 'c' is outside [-90, 90]"));

  given.stations = "id,lon,lat\na,35,132.5\nb,15,50\nc,100,95\nd,600,0\n";
  found = complaints_of([&] { given.study(); });
  ASSERT_EQ(found.size(), 3U);
  EXPECT_TRUE(found[0].ends_with("s.csv:2: latitude 132.5 of station 'a' is outside [-90, 90]"));
  EXPECT_TRUE(found[1].ends_with("s.csv:4: latitude 95 of station 'c' is outside [-90, 90]"));
  EXPECT_TRUE(found[2].ends_with("s.csv:5: longitude 600 of station 'd' is outside [-540, 540]"));
}

TEST(Study, a_basin_looks_swapped_where_no_corner_of_it_is_well) {
  Given given;
  given.basins = geojson("[[50,100],[51,100],[51,101],[50,100]]");
  EXPECT_TRUE(contains(complaint_of([&] { given.study(); }),
                       "latitude 100 of basin '1' (features[0].geometry) is outside [-90, 90] | "
                       "latitude and longitude look swapped"));
  given.basins = geojson("[[15,50],[16,50],[16,95],[15,50]]");
  EXPECT_FALSE(contains(complaint_of([&] { given.study(); }), "swapped"));
}

TEST(Study, longitudes_beyond_180_are_taken_round_with_one_warning) {
  Given given;
  given.with_basins = false;
  given.stations = "id,lon,lat\na,185,1\nb,-190,2\nc,359.5,3\nd,360,4\ne,540,5\nf,180,6\n";
  const StudyFiles study = given.study();
  const double expected[] = {-175, 170, -0.5, 0, 180, 180};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(std::abs(study.stations[i].position.x), std::abs(expected[i])) << i;
  EXPECT_EQ(study.stations[0].position.x, -175);
  EXPECT_EQ(study.stations[1].position.x, 170);
  ASSERT_EQ(given.warnings.messages().size(), 1U);
  EXPECT_TRUE(given.warning(0).ends_with(
      "s.csv:2: longitude 185 of station 'a' is taken for -175, and 4 others likewise"));
}

TEST(Study, coordinates_that_do_not_fit_their_crs_are_named_with_it) {
  Given given;
  given.stations = "id,lon,lat\na,350000,5500000\nb,360000,5600000\n";
  const std::string metres = complaint_of([&] { given.study(); });
  EXPECT_TRUE(contains(metres,
                       "coordinates are not degrees, but the names of its columns say EPSG:4326: "
                       "x from 350000 to 360000 and y from 5500000 to 5600000"))
      << metres;
  given.stations = "id,x,y\na,15,50\nb,16,51\n";
  given.request.stations.source.crs = "EPSG:32633";
  const std::string degrees = complaint_of([&] { given.study(); });
  EXPECT_TRUE(contains(degrees,
                       "coordinates look like degrees, but 'crs' says EPSG:32633, which "
                       "is projected: x from 15 to 16 and y from 50 to 51"))
      << degrees;
}

TEST(Study, planar_degrees_do_not_go_round_the_earth) {
  Given given;
  given.with_basins = false;
  given.request.metric = Metric::planar;
  given.stations = "id,lon,lat\na,170,1\nb,185,2\nc,-175,3\n";
  EXPECT_TRUE(contains(complaint_of([&] { given.study(); }),
                       "s.csv:3: longitude 185 of station 'b' beside -175 of station 'c': planar"));
  given.stations = "id,lon,lat\na,-190,1\nb,10,2\n";
  EXPECT_TRUE(contains(complaint_of([&] { given.study(); }),
                       "s.csv:2: longitude -190 of station 'a' beside 10 of station 'b'"));
  given.stations = "id,lon,lat\na,170,1\nb,185,2\n";
  EXPECT_EQ(given.study().stations.at(1).position, (Point{185, 2}));
  given.with_basins = true;
  given.basins = geojson("[[-180,0],[-170,0],[-170,10],[-180,0]]");
  EXPECT_TRUE(contains(complaint_of([&] { given.study(); }),
                       "s.csv:3: longitude 185 of station 'b' beside -180 of basin '1'"));
}

TEST(Study, a_station_far_from_its_zone_is_named) {
  Given given;
  given.with_basins = false;
  given.stations = "id,lon,lat\na,15,50\nb,-120,40\n";
  given.request.plane = "EPSG:32633";
  const std::string found = complaint_of([&] { given.study(); });
  EXPECT_TRUE(contains(
      found, "s.csv:3: station 'b' at -120 40 lies outside the projection's area (EPSG:32633)"))
      << found;
}

TEST(Study, other_bodies_and_unknown_texts_are_refused) {
  Given given;
  given.request.plane = "EPSG:99999";
  EXPECT_TRUE(contains(complaint_of([&] { given.study(); }), "'plane' 'EPSG:99999' is not known"));
}

TEST(Study, a_basin_over_the_antimeridian_runs_on) {
  Given given;
  given.stations = "id,lon,lat\na,179,0\nb,-179,1\n";
  given.basins = geojson("[[178,-1],[-178,-1],[-178,2],[178,2],[178,-1]]");
  const StudyFiles study = given.study();
  EXPECT_EQ(study.basins.at(0).shape.at(0).outer, (Ring{{178, -1}, {182, -1}, {182, 2}, {178, 2}}));
}

TEST(Study, stations_take_the_basins_crs_where_planar_is_asked_for) {
  Given given;
  given.basins = square(500000, 5500000, 1000);
  given.basins_name = "b.csv";
  given.request.basins.emplace();
  given.request.basins->source.crs = "EPSG:32633";
  given.request.metric = Metric::planar;
  const StudyFiles study = given.study();
  EXPECT_EQ(study.crs->name(), "EPSG:32633");
  EXPECT_NEAR(study.stations.at(0).position.x, 500000, 1e-6);
  EXPECT_TRUE(study.stations_crs->is_wgs84());
}

}  // namespace
}  // namespace thiessen
