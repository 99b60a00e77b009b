#include "files/study_on_earth.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "outlines/ellipsoid_strip.h"
#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

constexpr double chord = 0.025;  // metres

Ring rectangle(double west, double south, double east, double north) {
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

/// A study of a plane of this CRS, with one basin or study area.
StudyFiles planar(const std::string& crs, const Ring& ring) {
  StudyFiles study;
  study.crs = study.stations_crs = study.basins_crs = Crs::from_text(crs, setting("crs"));
  study.basins = {{"B", {{ring, {}}}, {}}};
  study.native_basins = {study.basins[0].shape};
  return study;
}

StudyParts on_earth(const StudyFiles& study, const std::vector<Point>& gauges) {
  std::vector<Station> stations;
  for (const Point p : gauges) stations.push_back({"g" + std::to_string(stations.size()), p});
  return study_on_earth(study, Network(stations, Metric::planar), chord);
}

// UTM zone 33: the easting of 500 km is the meridian of 15 degrees, and the northing 0 the equator.
TEST(StudyOnEarth, is_in_longitude_and_latitude) {
  const StudyParts parts =
      on_earth(planar("EPSG:32633", rectangle(400000, 0, 600000, 1000)), {{500000, 0}});
  EXPECT_EQ(parts.metric, Metric::geodesic);
  EXPECT_TRUE(parts.has_basins);
  ASSERT_EQ(parts.stations.size(), 1U);
  EXPECT_EQ(parts.stations[0].id, "g0");
  EXPECT_NEAR(parts.stations[0].position.x, 15, 1e-12);
  EXPECT_NEAR(parts.stations[0].position.y, 0, 1e-12);
  ASSERT_EQ(parts.basins.size(), 1U);
  EXPECT_EQ(parts.basins[0].id, "B");
}

// In the equal-area cylinder EPSG:6933 (true at 30 degrees) areas are the Earth's, edges and all:
// what the chords cut off is in the bulges.
TEST(StudyOnEarth, basins_keep_the_edges_of_their_file) {
  const Ring slanted = {{0, 0}, {1e6, 3e6}, {0, 5e6}};
  const StudyParts parts = on_earth(planar("EPSG:6933", slanted), {{1e5, 1e6}});
  const CurvedShape shape{parts.basins[0].shape, parts.basins[0].bulges};
  EXPECT_NEAR(area_on_earth(shape) / 2.5e12, 1, 1e-9);
  EXPECT_GT(shape.shape[0].outer.size(), 100U);
}

// A basin of a plane may be drawn anew there; the file's own is what counts.
TEST(StudyOnEarth, basins_are_those_of_their_file_in_its_crs) {
  StudyFiles study = planar("EPSG:32633", rectangle(400000, 0, 600000, 1000));
  study.native_basins = {{{rectangle(3, 4, 5, 6), {}}}};
  study.basins_crs = Crs::wgs84();
  const StudyParts parts = on_earth(study, {{500000, 0}});
  EXPECT_EQ(parts.basins[0].shape[0].outer, rectangle(3, 4, 5, 6));
  EXPECT_TRUE(parts.basins[0].bulges.empty());
}

TEST(StudyOnEarth, without_basins_the_study_area_is_taken_there) {
  StudyFiles study = planar("EPSG:4326", rectangle(14, 49, 16, 51));
  study.has_basins = false;
  study.native_basins.clear();
  study.basins_crs.reset();
  const StudyParts parts = on_earth(study, {{15, 50}});
  EXPECT_FALSE(parts.has_basins);
  EXPECT_EQ(parts.basins[0].shape[0].outer, rectangle(14, 49, 16, 51));
}

TEST(StudyOnEarth, longitudes_go_on_over_the_antimeridian) {
  const StudyFiles study = planar("EPSG:4326", {{170, 0}, {-170, 0}, {-170, 10}, {170, 10}});
  const StudyParts parts = on_earth(study, {{175, 5}, {190, 5}});
  EXPECT_EQ(parts.stations[0].position, (Point{175, 5}));
  EXPECT_EQ(parts.stations[1].position, (Point{-170, 5}));
  EXPECT_EQ(plane_area(parts.basins[0].shape), 200);
}

TEST(StudyOnEarth, says_what_lies_outside_the_projection) {
  const StudyFiles good = planar("EPSG:32633", rectangle(400000, 0, 600000, 1000));
  EXPECT_EQ(complaint_of([&] {
              on_earth(good, {{500000, 0}, {9e7, 0}});
            }),
            "station 'g1' lies outside the projection's area");
  const StudyFiles bad = planar("EPSG:32633", rectangle(400000, 0, 9e7, 1000));
  EXPECT_EQ(complaint_of([&] {
              on_earth(bad, {{500000, 0}});
            }),
            "basin 'B' lies outside the projection's area");
}

}  // namespace
}  // namespace thiessen
