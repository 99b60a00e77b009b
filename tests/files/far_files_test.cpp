#include "files/far_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace thiessen {
namespace {

Crs far_crs(const std::string& text) {
  return Crs::from_text(text, setting("crs"));
}

std::vector<std::string> texts_of(const std::vector<FarCause>& causes) {
  std::vector<std::string> texts;
  for (const FarCause& cause : causes) texts.push_back(cause.text.plain());
  return texts;
}

/// The correction of the cause with this text; of the gauges or of the basins, whichever it has.
FarCause::Correction correction(const std::vector<FarCause>& causes, const std::string& text) {
  for (const FarCause& cause : causes) {
    if (cause.text.plain() != text) continue;
    EXPECT_NE(static_cast<bool>(cause.gauges), static_cast<bool>(cause.basins)) << text;
    EXPECT_EQ(static_cast<bool>(cause.gauges), text.starts_with("the gauges'")) << text;
    return cause.gauges ? cause.gauges : cause.basins;
  }
  ADD_FAILURE() << "no cause is " << text;
  return [](std::vector<Point> points) { return points; };
}

void expect_near(const std::vector<Point>& found, Point wanted, double to) {
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].x, wanted.x, to);
  EXPECT_NEAR(found[0].y, wanted.y, to);
}

TEST(FarFiles, words_where_a_files_coordinates_are) {
  Reach reach;
  reach.see({10, 47});
  reach.see({11.5, 47});
  EXPECT_EQ(extent_text(reach, Crs::wgs84()),
            "longitude 10 to 11.5, latitude 47 (" + Crs::wgs84().name() + ")");
  EXPECT_EQ(extent_text(reach, far_crs("EPSG:32633")), "x 10 to 11.5, y 47 (EPSG:32633)");
}

// In degrees alike the mistake may be in either file, so one correction stands for both.
TEST(FarFiles, of_two_files_in_degrees_there_are_three_causes) {
  const Crs degrees = Crs::wgs84();
  const auto causes = far_causes_of_files(degrees, degrees, degrees);
  const std::string whose = "the gauges' (or the basins') ";
  const std::string swapped = whose + "latitude and longitude swapped";
  const std::string west = whose + "longitudes of the other sign (west is negative)";
  const std::string south = whose + "latitudes of the other sign (south is negative)";
  EXPECT_EQ(texts_of(causes), (std::vector<std::string>{swapped, west, south}));
  expect_near(correction(causes, swapped)({{47, 11}}), {11, 47}, 1e-12);
  expect_near(correction(causes, west)({{105, 40}}), {-105, 40}, 1e-12);
  expect_near(correction(causes, south)({{18, 33}}), {18, -33}, 1e-12);
}

// The study is in degrees; the gauges' file has UTM zone 33, whose easting of 500 km is the
// meridian of 15 degrees. The file's numbers are changed, not the study's.
TEST(FarFiles, corrections_change_the_numbers_of_the_file) {
  const Crs utm = far_crs("EPSG:32633");
  const auto causes = far_causes_of_files(utm, Crs::wgs84(), Crs::wgs84());
  // The equator 1 degree west of the zone's meridian, mirrored: easting 500 - 111 km becomes its
  // negative, and a northing of 0 stays.
  expect_near(correction(causes, "the gauges' northings of the other sign")({{14, 20}}), {14, -20},
              1e-9);
  // 0.5 east and 0 north in kilometres is the central meridian on the equator.
  const Point wrong = correction(causes, "the gauges' eastings of the other sign")({{15, 0}})[0];
  EXPECT_LT(wrong.x, 15 - 8.9);  // 1,000 km further west
  EXPECT_GT(wrong.x, 15 - 9.1);
  const auto swapped = correction(causes, "the gauges' eastings and northings swapped")({{15, 0}});
  EXPECT_NEAR(swapped[0].y, 500 / 0.9996 / 110.574, 0.02);  // 500 km north, a degree is 110.574 km
}

TEST(FarFiles, kilometres_are_a_thousand_times_as_much) {
  const Crs plane = far_crs("EPSG:32633");
  const auto causes = far_causes_of_files(plane, far_crs("EPSG:2263"), plane);
  expect_near(
      correction(causes, "the gauges' coordinates in kilometres, not metres")({{500, 5200}}),
      {500000, 5200000}, 1e-6);
  // EPSG:2263 is in feet.
  const auto texts = texts_of(causes);
  EXPECT_EQ(
      std::count(texts.begin(), texts.end(), "the basins' coordinates in kilometres, not its unit"),
      1);
}

// The gauges' file names UTM zone 33 where its numbers are of another: on the zones' own meridians,
// 500 km east, only the longitude is another.
TEST(FarFiles, a_zone_beside_may_be_meant) {
  const auto causes = far_causes_of_files(far_crs("EPSG:32633"), Crs::wgs84(), Crs::wgs84());
  expect_near(correction(causes, "the gauges' coordinates in EPSG:32632")({{15, 50}}), {9, 50},
              1e-9);
  expect_near(correction(causes, "the gauges' coordinates in EPSG:32635")({{15, 50}}), {27, 50},
              1e-9);
  // South of the equator northings count from 10,000 km: 5,000 km north is as far south.
  const double middle = 45.15338;  // near the latitude of northing 5,000 km
  const auto south = correction(causes, "the gauges' coordinates in EPSG:32733")({{15, middle}});
  EXPECT_NEAR(south[0].x, 15, 1e-9);
  EXPECT_NEAR(south[0].y, -middle, 0.01);
  EXPECT_EQ(correction(causes, "the basins' coordinates in EPSG:32633")({{500000, 5e6}}).size(),
            1U);
}

std::vector<std::string> zones_named(const std::string& crs) {
  const std::string start = "the gauges' coordinates in EPSG:";
  std::vector<std::string> zones;
  for (const std::string& text :
       texts_of(far_causes_of_files(far_crs(crs), far_crs(crs), far_crs(crs)))) {
    if (text.starts_with(start)) zones.push_back(text.substr(start.size()));
  }
  return zones;
}

TEST(FarFiles, zones_beside_are_two_to_either_side_round_the_earth_and_the_other_hemisphere) {
  using Zones = std::vector<std::string>;
  EXPECT_EQ(zones_named("EPSG:32633"), (Zones{"32733", "32632", "32732", "32634", "32734", "32631",
                                              "32731", "32635", "32735"}));
  EXPECT_EQ(zones_named("EPSG:32701"), (Zones{"32601", "32760", "32660", "32702", "32602", "32759",
                                              "32659", "32703", "32603"}));
  EXPECT_EQ(zones_named("EPSG:32660").at(3), "32601");
  EXPECT_TRUE(zones_named("EPSG:32661").empty());  // the pole's, no zone
  EXPECT_TRUE(zones_named("EPSG:25833").empty());
}

TEST(FarFiles, the_crs_of_the_other_file_may_be_meant) {
  const Crs utm = far_crs("EPSG:32633");
  const auto causes = far_causes_of_files(Crs::wgs84(), utm, Crs::wgs84());
  // On the meridian of 15 degrees the basins' file says 500,000 metres.
  const auto numbers =
      correction(causes, "the basins' coordinates in " + Crs::wgs84().name())({{15, 50}});
  EXPECT_NEAR(numbers[0].x, 500000, 1e-3);
  // Degrees that are metres lie 500 km west of the zone's meridian, at the equator.
  const auto corner = correction(causes, "the gauges' coordinates in EPSG:32633")({{15, 50}});
  EXPECT_NEAR(corner[0].x, 15 - 500 / 0.9996 / 111.32, 0.01);
  EXPECT_NEAR(corner[0].y, 0, 1e-3);
  // So near the equator there is nothing of the zone of Europe's own datum.
  const auto nowhere = far_causes_of_files(Crs::wgs84(), far_crs("EPSG:25833"), Crs::wgs84());
  const auto lost = correction(nowhere, "the gauges' coordinates in EPSG:25833")({{15, 50}});
  EXPECT_TRUE(std::isnan(lost[0].x) && std::isnan(lost[0].y));
}

}  // namespace
}  // namespace thiessen
