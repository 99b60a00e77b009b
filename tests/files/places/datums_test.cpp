#include "files/places/datums.h"

#include <gtest/gtest.h>
#include <cmath>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "files/study_files.h"

namespace thiessen {
namespace {

/// Two CSV files, each with its CRS.
struct Given {
  std::string stations = "id,x,y\na,100.2,15.3\nb,100.8,15.6\n";
  std::string basins = "id,WKT\nq,\"POLYGON ((100 15,101 15,101 16,100 16,100 15))\"\n";
  std::string stations_crs;
  std::string basins_crs;
  StudyRequest request = {};
  Warnings warnings = {};

  StudyFiles study() {
    const TemporaryFolder folder;
    request.stations.source.file = folder.write("s.csv", stations);
    request.stations.source.crs = stations_crs;
    request.basins.emplace();
    request.basins->source.file = folder.write("b.csv", basins);
    request.basins->source.crs = basins_crs.empty() ? stations_crs : basins_crs;
    request.basins->source.crs_setting = "basins_crs";
    return read_study(request, warnings);
  }
};

TEST(Datums, a_coarse_shift_is_warned_of_once_with_its_metres) {
  Given given;
  given.stations_crs = "EPSG:4239";  // Indian 1954
  given.study();
  ASSERT_EQ(given.warnings.messages().size(), 1U);
  EXPECT_TRUE(
      sentences_of(given.warnings)[0].ends_with("s.csv: EPSG:4239 is taken to EPSG:4326 to within "
                                                "21 m only, by 'Indian 1954 to WGS 84 (1)'"));
}

TEST(Datums, modern_frames_are_silent) {
  for (const char* frame : {"EPSG:4269", "EPSG:4258", "EPSG:4283", "EPSG:7844", "EPSG:9057",
                            "EPSG:9000", "+proj=longlat +ellps=GRS80"}) {
    Given given;
    given.stations_crs = frame;
    EXPECT_EQ(given.study().metric, Metric::geodesic);
    EXPECT_TRUE(given.warnings.messages().empty()) << frame;
  }
}

TEST(Datums, a_sphere_is_warned_of_once) {
  Given given;
  given.stations_crs = "+proj=longlat +R=6370000";
  const StudyFiles study = given.study();
  EXPECT_EQ(study.stations.at(0).position, (Point{100.2, 15.3}));
  ASSERT_EQ(given.warnings.messages().size(), 1U);
  EXPECT_TRUE(sentences_of(given.warnings)[0].ends_with(
      "s.csv: '+proj=longlat +R=6370000' is a sphere without a datum: its longitudes and latitudes "
      "are taken for EPSG:4326's"));
}

TEST(Datums, an_unknown_datum_is_refused_with_the_file_and_serves_a_plane) {
  Given given;
  given.stations_crs = "EPSG:4004";
  EXPECT_TRUE(contains(complaint_of([&] { given.study(); }),
                       "s.csv: no transformation of datum from EPSG:4004 to EPSG:4326 is known: "
                       "coordinates on 'Bessel 1841' without a known datum may be hundreds of "
                       "metres off | name a CRS whose datum is known"));
  given.request.plane = "+proj=utm +zone=47 +ellps=bessel";
  EXPECT_EQ(given.study().metric, Metric::planar);
  given.request.plane.clear();
  given.request.metric = Metric::planar;
  EXPECT_EQ(given.study().stations.at(0).position, (Point{100.2, 15.3}));
}

TEST(Datums, a_place_in_two_files_of_one_datum_stays_one_place) {
  Given given;
  given.stations_crs = "+proj=utm +zone=47 +a=6377276.345 +rf=300.8017 +towgs84=217,823,299";
  given.stations = "id,x,y\na,500000,0\n";  // on the equator at 99 degrees east
  given.basins_crs = "EPSG:4239";
  given.basins = "id,WKT\nq,\"POLYGON ((99 0,100 0,100 1,99 0))\"\n";
  const StudyFiles study = given.study();
  const Point station = study.stations.at(0).position;
  const Point corner = study.basins.at(0).shape.at(0).outer.at(0);
  EXPECT_NEAR(station.x, corner.x, 1e-12);
  EXPECT_NEAR(station.y, corner.y, 1e-12);
  EXPECT_GT(std::abs(station.x - 99), 0.001);
}

// New Zealand's grid ends long before Thailand; a translation does not.
TEST(Datums, a_grid_that_does_not_reach_the_gauges_is_not_chosen) {
  Given given;
  given.stations_crs = "EPSG:4272";
  EXPECT_NEAR(given.study().stations.at(0).position.x, 100.2, 0.01);
}

// The widest gap between stations is not the one over the antimeridian.
TEST(Datums, the_area_goes_the_short_way_round) {
  Given given;
  given.stations_crs = "EPSG:4720";  // Fiji 1986; its area of use is 176.81 to -178.15
  given.stations = "id,x,y\na,178.5,-18\nb,-179.5,-17\n";
  given.basins = "id,WKT\nq,\"POLYGON ((178 -18,179 -18,179 -17,178 -17,178 -18))\"\n";
  const Box area = given.study().stations_crs->area().value();
  EXPECT_NEAR(area.low.x, 178, 0.05);
  EXPECT_NEAR(area.high.x, 180.5, 0.05);
}

}  // namespace
}  // namespace thiessen
