#include "gdal/crs/crs.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace thiessen
