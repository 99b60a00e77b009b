#include "files/places/crs_agreement.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

/// Two files that have been read, and what is asked of them.
struct Given {
  StationsFile stations;
  BasinsFile basins;
  Asked asked = Asked::nothing;
  Warnings warnings = {};

  Given() {
    stations.file = "s";
    basins.file = "b";
    stations.has_lines = true;
    basins.basins.push_back({"q", "basin 'q'", 2, {{{}, {}}}});
    set_stations({{10, 50}, {11, 51}});
    set_square({10, 50}, 1);
  }
  void set_stations(const std::vector<Point>& points) {
    stations.stations.clear();
    for (const Point p : points)
      stations.stations.push_back({"g", p, stations.stations.size() + 2});
  }
  void set_square(Point low, double side) {
    basins.basins[0].polygons[0].outer = {
        low, {low.x + side, low.y}, {low.x + side, low.y + side}, {low.x, low.y + side}, low};
  }
  std::vector<std::string> agreed() {
    warnings = {};
    agree_on_crs(stations, &basins, asked, warnings);
    return sentences_of(warnings);
  }
  std::string complaint() {
    return complaint_of([&] { agreed(); });
  }
};

template <typename File>
void name_crs(File& file, const char* crs, CrsOrigin origin = CrsOrigin::file) {
  file.crs = Crs::from_text(crs, "CRS");
  file.crs_origin = origin;
}

// Law 1: who names a CRS lends it, however it is known.
TEST(CrsAgreement, law_1_a_crs_holds_for_the_file_without_one) {
  for (const CrsOrigin origin :
       {CrsOrigin::file, CrsOrigin::implied, CrsOrigin::option, CrsOrigin::columns}) {
    Given given;
    name_crs(given.basins, "EPSG:4326", origin);
    ASSERT_EQ(given.agreed().size(), 1U);
    EXPECT_TRUE(given.stations.crs->is_wgs84());
    EXPECT_EQ(given.stations.crs_origin, CrsOrigin::lent);
    EXPECT_EQ(sentences_of(given.warnings)[0],
              "s: names no CRS; that of b, EPSG:4326 (WGS 84), is taken");

    Given other;
    name_crs(other.stations, "EPSG:4326", origin);
    ASSERT_EQ(other.agreed().size(), 1U);
    EXPECT_TRUE(other.basins.crs->is_wgs84());
  }
}

TEST(CrsAgreement, law_1_holds_for_other_datums_and_units) {
  for (const char* crs : {"EPSG:4267", "EPSG:4807", "+proj=longlat +R=6370000"}) {
    Given given;
    name_crs(given.basins, crs);
    given.agreed();
    EXPECT_TRUE(given.stations.crs->same_as(*given.basins.crs)) << crs;
  }
}

TEST(CrsAgreement, law_2_metres_are_not_degrees_whichever_file_has_them) {
  Given given;
  name_crs(given.basins, "EPSG:4326", CrsOrigin::implied);
  given.set_stations({{583500, 5217000}, {643900, 5228800}});
  EXPECT_EQ(given.complaint(),
            "s: coordinates are not degrees, but it names no CRS and would take that of b, "
            "EPSG:4326: x from 583500 to 643900 and y from 5217000 to 5228800 | name the CRS that "
            "they are in with 'crs'");
  Given other;
  name_crs(other.stations, "EPSG:4326", CrsOrigin::implied);
  other.set_square({500000, 5500000}, 1000);
  EXPECT_TRUE(contains(other.complaint(), "name the CRS that they are in with 'basins_crs'"));
}

// A small plane beside degrees: nothing is far from the range of degrees, and yet beyond it.
TEST(CrsAgreement, law_2_holds_for_small_numbers) {
  Given given;
  name_crs(given.basins, "EPSG:4326", CrsOrigin::implied);
  given.set_stations({{200, 10}, {300, 400}});
  EXPECT_EQ(given.complaint(),
            "s:3: latitude 400 of station 'g' is outside [-90, 90] | name the CRS that they are in "
            "with 'crs'");
}

TEST(CrsAgreement, law_2_swapped_degrees_are_told) {
  Given given;
  name_crs(given.basins, "EPSG:4326", CrsOrigin::implied);
  given.set_stations({{35, 132.5}, {36, 133}});
  EXPECT_TRUE(contains(given.complaint(), "columns look swapped"));
}

TEST(CrsAgreement, law_3_degrees_are_not_metres) {
  Given given;
  name_crs(given.basins, "EPSG:32632");
  given.set_square({583500, 5217000}, 1000);
  EXPECT_EQ(given.complaint(),
            "s: coordinates look like degrees, but it names no CRS and would take that of b, "
            "EPSG:32632, which is projected: x from 10 to 11 and y from 50 to 51 | longitude and "
            "latitude are crs = EPSG:4326");
  given.stations.crs.reset();
  given.stations.crs_origin = CrsOrigin::none;
  given.set_stations({{583600, 5217100}});
  EXPECT_EQ(given.agreed().size(), 1U);
}

TEST(CrsAgreement, law_4_a_plane_is_assumed_with_a_word) {
  Given given;
  ASSERT_EQ(given.agreed().size(), 1U);
  EXPECT_EQ(
      sentences_of(given.warnings)[0],
      "s: names no CRS, and neither does b: the coordinates are taken as a plane, though they "
      "could be degrees");
  EXPECT_FALSE(given.stations.crs);
  for (const Asked asked : {Asked::plane, Asked::crs}) {
    given.asked = asked;
    EXPECT_TRUE(given.agreed().empty());
  }
  given.asked = Asked::nothing;
  given.set_square({0, 0}, 91);
  EXPECT_TRUE(given.agreed().empty());
}

TEST(CrsAgreement, law_4_holds_without_basins) {
  Given given;
  agree_on_crs(given.stations, nullptr, Asked::nothing, given.warnings);
  ASSERT_EQ(given.warnings.messages().size(), 1U);
  EXPECT_EQ(sentences_of(given.warnings)[0],
            "s: names no CRS: the coordinates are taken as a plane, though they could be degrees");
}

TEST(CrsAgreement, law_5_what_cannot_be_degrees_implies_no_crs) {
  Given given;
  name_crs(given.basins, "EPSG:4326", CrsOrigin::implied);
  given.set_square({500000, 5500000}, 1000);
  given.set_stations({{500100, 5500100}});
  EXPECT_TRUE(given.agreed().empty());
  EXPECT_FALSE(given.basins.crs);
}

// Three of the five corners of the square could be degrees.
TEST(CrsAgreement, law_6_a_file_that_could_be_degrees_in_part_is_one_of_a_plane_beside_a_plane) {
  Given given;
  name_crs(given.basins, "EPSG:4326", CrsOrigin::implied);
  given.set_square({0, 0}, 100);
  ASSERT_EQ(given.agreed().size(), 1U);
  EXPECT_FALSE(given.basins.crs);
  EXPECT_FALSE(given.stations.crs);
  EXPECT_TRUE(contains(sentences_of(given.warnings)[0], "not all of its coordinates can be"));

  name_crs(given.basins, "EPSG:4326", CrsOrigin::implied);
  given.asked = Asked::plane;
  EXPECT_TRUE(given.agreed().empty());
  EXPECT_FALSE(given.basins.crs);
}

TEST(CrsAgreement, law_6_beside_degrees_the_odd_numbers_are_slips) {
  Given given;
  name_crs(given.basins, "EPSG:4326", CrsOrigin::implied);
  name_crs(given.stations, "EPSG:4326", CrsOrigin::columns);
  given.set_square({0, 0}, 100);
  EXPECT_EQ(given.complaint(), "b:2: latitude 100 of basin 'q' is outside [-90, 90]");
}

// A setting against the CRS that a file names is refused, so it must not be what a hint says.
TEST(CrsAgreement, law_7_hints_are_no_circle) {
  Given given;
  name_crs(given.basins, "EPSG:4326");
  name_crs(given.stations, "EPSG:4326", CrsOrigin::columns);
  given.set_square({500000, 5500000}, 1000);
  EXPECT_TRUE(contains(given.complaint(), "its CRS is EPSG:4326"));
  EXPECT_FALSE(contains(given.complaint(), "basins_crs"));
}

}  // namespace
}  // namespace thiessen
