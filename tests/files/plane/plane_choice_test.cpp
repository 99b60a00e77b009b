#include "files/plane/plane_choice.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "base/complaints.h"

namespace thiessen {
namespace {

StationsFile stations_at(const std::vector<Point>& positions, const std::string& crs) {
  StationsFile stations;
  stations.file = "s.csv";
  stations.crs = Crs::from_text(crs, setting("crs"));
  for (const Point p : positions)
    stations.stations.push_back({"g" + std::to_string(stations.stations.size()), p});
  return stations;
}

StudyPlane plane_of(const StationsFile& stations, Warnings& warnings) {
  return choose_plane(stations, {}, std::nullopt, Crs::wgs84(), warnings);
}

TEST(PercentText, has_two_digits_that_tell_and_all_before_the_point) {
  EXPECT_EQ(percent_text(0.00042), "0.042 %");
  EXPECT_EQ(percent_text(0.0123), "1.2 %");
  EXPECT_EQ(percent_text(0.123), "12 %");
  EXPECT_EQ(percent_text(3.21), "321 %");
  EXPECT_EQ(percent_text(0.00996), "1.0 %");
  EXPECT_EQ(percent_text(0), "0 %");
  EXPECT_EQ(percent_text(1e-13), "0 %");
}

// Three degrees from its central meridian, at the equator, the transverse Mercator projection's
// scale is 1 + u^2/2 (1 + e'^2) + 5 u^4/24, u = pi/60 (Snyder 1987, 8-11): 1.0013815. Halved
// between the outermost and the meridian, lengths are off by 0.0013815 / 2.0013815 = 0.069 %. No
// cone or cylinder along the equator comes near that at 20 degrees from it.
TEST(PlaneChoice, tells_the_plane_and_how_far_lengths_are_off) {
  Warnings warnings;
  const StudyPlane plane =
      plane_of(stations_at({{6, 0}, {12, 0}, {9, 20}, {9, -20}}, "EPSG:4326"), warnings);
  EXPECT_EQ(plane.plane.parameters().kind, ProjectionKind::transverse_mercator);
  EXPECT_NEAR(plane.plane.parameters().longitude, 9, 1e-9);
  EXPECT_NEAR(plane.scale_error, 0.000690, 0.00002);
  EXPECT_EQ(sentences_of(warnings),
            (std::vector<std::string>{"the plane is " + plane.plane.proj_text() +
                                      ", in which lengths are off by up to 0.069 %"}));
}

// UTM zone 33's easting of 500 km is the meridian of 15 degrees.
TEST(PlaneChoice, takes_gauges_and_basins_each_from_their_own_crs) {
  const StationsFile stations = stations_at({{500000, 4000000}, {500000, 7000000}}, "EPSG:32633");
  Warnings warnings;
  EXPECT_NEAR(plane_of(stations, warnings).plane.parameters().longitude, 15, 1e-9);
  const std::vector<MultiPolygon> basins = {{{{{14, 40}, {20, 45}, {14, 45}}, {}}}};
  const StudyPlane both = choose_plane(stations, basins, Crs::wgs84(), Crs::wgs84(), warnings);
  EXPECT_GT(both.plane.parameters().longitude, 16);
}

TEST(PlaneChoice, passes_over_what_is_nowhere_on_the_earth) {
  Warnings warnings;
  const StationsFile stations =
      stations_at({{500000, 4000000}, {9e7, 5500000}, {500000, 7000000}}, "EPSG:32633");
  const std::vector<MultiPolygon> basins = {{{{{15, 40}, {15, 200}, {15, 45}}, {}}}};
  const StudyPlane plane = choose_plane(stations, basins, Crs::wgs84(), Crs::wgs84(), warnings);
  EXPECT_NEAR(plane.plane.parameters().longitude, 15, 1e-9);
  EXPECT_LT(plane.scale_error, 1e-6);
}

TEST(PlaneChoice, where_no_station_is_on_the_earth_the_stations_are_to_blame) {
  const StationsFile lost = stations_at({{9e7, 5500000}}, "EPSG:32633");
  Warnings warnings;
  EXPECT_EQ(complaint_of([&] { plane_of(lost, warnings); }),
            "s.csv: no station lies in the projection's area (EPSG:32633)");
}

// Seen from the pole the equator is 2 where the pole is 1, and the outermost are a third off.
TEST(PlaneChoice, refuses_a_study_of_half_the_earth) {
  Warnings warnings;
  const StationsFile wide = stations_at({{0, 0}, {120, 0}, {-120, 0}, {0, 80}}, "EPSG:4326");
  EXPECT_EQ(complaint_of([&] { plane_of(wide, warnings); }),
            "no plane suits gauges and basins that lie so far apart: lengths would be off by up "
            "to 33 % | metric = geodesic measures the Earth as it is");
  EXPECT_TRUE(warnings.messages().empty());
}

}  // namespace
}  // namespace thiessen
