#include "files/places/crs_fit.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

StationsFile stations(const std::string& crs, const std::vector<Point>& points,
                      CrsOrigin origin = CrsOrigin::option) {
  StationsFile file;
  file.file = "s.csv";
  for (const Point point : points) file.stations.push_back({"a", point, 2});
  file.crs = Crs::from_text(crs, setting("crs"));
  file.crs_origin = origin;
  return file;
}

bool fits(const std::string& crs, const std::vector<Point>& points) {
  try {
    require_fit(stations(crs, points), "");
  } catch (const Error&) {
    return false;
  }
  return true;
}

TEST(CrsFit, degrees_fit_a_geographic_crs_and_lengths_do_not) {
  EXPECT_TRUE(fits("EPSG:4326", {{15, 50}, {-180, 90}}));
  EXPECT_FALSE(fits("EPSG:4326", {{350000, 5500000}, {360000, 5600000}}));
}

// One row that is wrong is told by its row, and not as a wrong CRS.
TEST(CrsFit, one_point_that_may_be_in_degrees_speaks_for_a_geographic_crs) {
  const auto complaint = [](const std::vector<Point>& points) {
    return complaint_of([&] { require_fit(stations("EPSG:4326", points), ""); });
  };
  EXPECT_EQ(complaint({{15, 50}, {350000, 5500000}}),
            "s.csv: feature 2: latitude 5500000 of station 'a' is outside [-90, 90]");
  EXPECT_EQ(complaint({{15, 50}, {541, 50}}),
            "s.csv: feature 2: longitude 541 of station 'a' is outside [-540, 540]");
  EXPECT_TRUE(fits("EPSG:4326", {{400, 5}, {-540, 85}})) << "as far as longitudes may run on";
}

TEST(CrsFit, lengths_fit_a_projection_and_what_may_be_degrees_does_not) {
  EXPECT_TRUE(fits("EPSG:32633", {{350000, 5500000}}));
  EXPECT_TRUE(fits("EPSG:32633", {{15, 50}, {350000, 50}})) << "all points have to look so";
  EXPECT_TRUE(fits("EPSG:3571", {{181, 50}}));
  EXPECT_TRUE(fits("EPSG:3571", {{15, 91}}));
  EXPECT_FALSE(fits("EPSG:3571", {{180, 90}, {-180, -90}}));
}

// Fifty kilometres from the origin are no degrees.
TEST(CrsFit, small_numbers_fit_a_projection_in_a_larger_unit) {
  EXPECT_TRUE(fits("+proj=laea +lat_0=90 +units=km", {{15, 50}}));
  EXPECT_FALSE(fits("+proj=laea +lat_0=90 +units=m", {{15, 50}}));
  EXPECT_FALSE(fits("EPSG:2263", {{15, 50}})) << "feet are shorter than metres";
}

TEST(CrsFit, says_by_whom_the_crs_is_named_and_what_the_coordinates_are) {
  const std::vector<Point> metres = {{350000, 5500000}, {360000, 5600000}};
  const auto complaint = [&](CrsOrigin origin) {
    return complaint_of([&] { require_fit(stations("EPSG:4326", metres, origin), ""); });
  };
  EXPECT_TRUE(contains(complaint(CrsOrigin::option), "'crs' says EPSG:4326"));
  EXPECT_TRUE(contains(complaint(CrsOrigin::columns), "names of its columns say EPSG:4326"));
  EXPECT_TRUE(contains(complaint(CrsOrigin::file), "its CRS is EPSG:4326"));
  EXPECT_TRUE(contains(complaint(CrsOrigin::object), "its CRS is EPSG:4326"));
  EXPECT_TRUE(contains(complaint(CrsOrigin::file), "ogr2ogr"));
  EXPECT_FALSE(contains(complaint(CrsOrigin::object), "ogr2ogr")) << "there is no file";
  for (const CrsOrigin origin :
       {CrsOrigin::option, CrsOrigin::columns, CrsOrigin::file, CrsOrigin::object}) {
    EXPECT_TRUE(complaint(origin).starts_with("s.csv: "));
    EXPECT_TRUE(
        contains(complaint(origin), "x from 350000 to 360000 and y from 5500000 to 5600000"));
  }
}

TEST(CrsFit, of_basins_names_the_basins_own_setting) {
  BasinsFile file;
  file.file = "b.json";
  file.basins = {{"q", "basin 'q'", 0, {{{{1, 2}, {3, 4}, {5, 2}}, {}}}}};
  file.crs = Crs::from_text("EPSG:32633", setting("basins_crs"));
  file.crs_origin = CrsOrigin::option;
  EXPECT_TRUE(
      contains(complaint_of([&] { require_fit(file, ""); }), "'basins_crs' says EPSG:32633"));
}

}  // namespace
}  // namespace thiessen
