#include "gdal/crs/crs.h"
#include "gdal/crs/transformation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/complaints.h"

namespace thiessen {
namespace {

Crs crs(const std::string& text) {
  return Crs::from_text(text, setting("crs"));
}

TEST(Crs, knows_codes_wkt_and_proj) {
  EXPECT_EQ(crs("EPSG:32633").name(), "EPSG:32633");
  EXPECT_FALSE(crs("EPSG:32633").geographic());
  EXPECT_EQ(crs("EPSG:32633").metres_per_unit(), 1);
  EXPECT_TRUE(crs("EPSG:4326").is_wgs84());
  EXPECT_TRUE(crs("OGC:CRS84").is_wgs84());
  EXPECT_FALSE(crs("EPSG:4269").is_wgs84());
  EXPECT_EQ(crs("EPSG:4326").degrees_per_unit(), 1);
  EXPECT_TRUE(crs("EPSG:32633").same_as(crs(crs("EPSG:32633").wkt())));
  EXPECT_TRUE(crs("+proj=utm +zone=33 +datum=WGS84 +units=m +no_defs").same_as(crs("EPSG:32633")));
  EXPECT_FALSE(crs("EPSG:32633").same_as(crs("EPSG:32634")));
}

TEST(Crs, knows_json_of_projs_own) {
  // As tools print it: over several lines, with a line before it.
  const Crs system = crs(R"(
{ "type": "GeographicCRS", "name": "NAD83",
  "datum": { "type": "GeodeticReferenceFrame", "name": "North American Datum 1983",
             "ellipsoid": { "name": "GRS 1980", "semi_major_axis": 6378137,
                            "inverse_flattening": 298.257222101 } },
  "coordinate_system": { "subtype": "ellipsoidal", "axis": [
    { "name": "Latitude", "abbreviation": "lat", "direction": "north", "unit": "degree" },
    { "name": "Longitude", "abbreviation": "lon", "direction": "east", "unit": "degree" } ] },
  "id": { "authority": "EPSG", "code": 4269 } }
)");
  EXPECT_TRUE(system.same_as(crs("EPSG:4269")));
}

TEST(Crs, knows_names_of_wgs84_whatever_their_case_axes_and_heights) {
  for (const char* name :
       {"epsg:4326", "urn:ogc:def:crs:EPSG::4326", "urn:ogc:def:crs:OGC:1.3:CRS84", "WGS84",
        "EPSG:4979", "EPSG:4326+5773", "+proj=longlat +datum=WGS84"}) {
    EXPECT_TRUE(crs(name).is_wgs84()) << name;
  }
}

TEST(Crs, without_code_or_name_is_called_by_its_text) {
  EXPECT_EQ(crs("+proj=longlat +ellps=bessel").name(), "'+proj=longlat +ellps=bessel'");
}

TEST(Crs, knows_feet) {
  // The US survey foot is 1200/3937 m.
  EXPECT_DOUBLE_EQ(crs("EPSG:2263").metres_per_unit(), 1200.0 / 3937.0);
}

class BadText : public testing::TestWithParam<std::string> {};

TEST_P(BadText, is_refused) {
  const std::string complaint = complaint_of([] { crs(GetParam()); });
  EXPECT_TRUE(complaint.starts_with("'crs' '")) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    Crs, BadText,
    testing::Values("EPSG:99999", "", "http://127.0.0.1:9/",
                    "https://spatialreference.org/ref/epsg/4326/", "/etc/passwd",
                    "+init=/etc/passwd:x", "+init=epsg:4326", "nonsense",
                    "+proj=pipeline +step +proj=utm +zone=33",
                    "+proj=utm +zone=33 +nadgrids=/etc/passwd", std::string("EPSG:4326\0x", 11),
                    std::string(1 << 20, 'x'), "GEOGCRS[" + std::string(60000, '['),
                    "EPSG:4978" /* geocentric */, "EPSG:5703" /* heights */,
                    "+proj=longlat +a=1737400 +b=1737400 +no_defs" /* Moon */));

TEST(Transformation, takes_east_before_north_whatever_the_authority_says) {
  // The false easting and the equator: the central meridian of zone 33 is 15 degrees east.
  const Transformation to_plane(crs("EPSG:4326"), crs("EPSG:32633"));
  const auto on_meridian = to_plane({15, 0});
  ASSERT_TRUE(on_meridian);
  EXPECT_NEAR(on_meridian->x, 500000, 1e-6);
  EXPECT_NEAR(on_meridian->y, 0, 1e-6);
  // Snyder, Map Projections (USGS 1395), p. 269: 40 30 N 73 30 W on Clarke 1866 is x = 627106.5 m,
  // y = 4484124.4 m in zone 18.
  const Transformation clarke(crs("+proj=longlat +ellps=clrk66 +no_defs"),
                              crs("+proj=utm +zone=18 +ellps=clrk66 +units=m +no_defs"));
  const auto snyder = clarke({-73.5, 40.5});
  ASSERT_TRUE(snyder);
  EXPECT_NEAR(snyder->x, 627106.5, 0.06);
  EXPECT_NEAR(snyder->y, 4484124.4, 0.06);
}

TEST(Transformation, knows_where_a_projection_ends) {
  const Transformation to_plane(crs("EPSG:4326"), crs("EPSG:32633"));
  EXPECT_FALSE(to_plane({-120, 40}));
  EXPECT_TRUE(to_plane({10, 50}));
  EXPECT_FALSE(Transformation(crs("EPSG:32633"), crs("EPSG:4326"))({1e9, 1e9}));
  std::vector<Point> points = {{10, 50}, {-120, 40}};
  EXPECT_EQ(to_plane.apply(points), (std::vector<bool>{true, false}));
  EXPECT_EQ(points[1], (Point{-120, 40}));
}

TEST(Transformation, of_a_crs_to_itself_changes_no_bit) {
  const Transformation same(crs("EPSG:4326"), crs("OGC:CRS84"));
  EXPECT_TRUE(same.identity());
  EXPECT_EQ(same({0.1, -0.3}), (Point{0.1, -0.3}));
}

}  // namespace
}  // namespace thiessen
