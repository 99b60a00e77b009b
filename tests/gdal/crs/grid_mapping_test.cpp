#include "gdal/crs/grid_mapping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace thiessen {
namespace {

GridMapping mapping_of(const char* code) {
  return grid_mapping(Crs::from_text(code, setting("crs")));
}

std::string name_of(const GridMapping& mapping) {
  for (const auto& [name, text] : mapping.texts) {
    if (name == "grid_mapping_name") return text;
  }
  return {};
}

std::vector<double> number(const GridMapping& mapping, const std::string& wanted) {
  for (const auto& [name, numbers] : mapping.numbers) {
    if (name == wanted) return numbers;
  }
  return {};
}

using Numbers = std::vector<double>;

// The values are those of the EPSG registry.
TEST(GridMapping, of_longitude_and_latitude) {
  const GridMapping wgs84 = mapping_of("EPSG:4326");
  EXPECT_EQ(name_of(wgs84), "latitude_longitude");
  EXPECT_EQ(wgs84.unit, "");
  EXPECT_EQ(number(wgs84, "semi_major_axis"), Numbers{6378137});
  EXPECT_EQ(number(wgs84, "inverse_flattening"), Numbers{298.257223563});
}

TEST(GridMapping, of_a_zone_of_utm) {
  const GridMapping utm = mapping_of("EPSG:32633");
  EXPECT_EQ(name_of(utm), "transverse_mercator");
  EXPECT_EQ(utm.unit, "m");
  EXPECT_EQ(number(utm, "longitude_of_central_meridian"), Numbers{15});
  EXPECT_EQ(number(utm, "latitude_of_projection_origin"), Numbers{0});
  EXPECT_EQ(number(utm, "scale_factor_at_central_meridian"), Numbers{0.9996});
  EXPECT_EQ(number(utm, "false_easting"), Numbers{500000});
  EXPECT_EQ(number(utm, "false_northing"), Numbers{0});
}

TEST(GridMapping, of_conics_and_azimuthals_of_europe) {
  const GridMapping lcc = mapping_of("EPSG:3034");
  EXPECT_EQ(name_of(lcc), "lambert_conformal_conic");
  EXPECT_EQ(number(lcc, "standard_parallel"), (Numbers{35, 65}));
  EXPECT_EQ(number(lcc, "latitude_of_projection_origin"), Numbers{52});
  EXPECT_EQ(number(lcc, "longitude_of_central_meridian"), Numbers{10});
  EXPECT_EQ(number(lcc, "false_northing"), Numbers{2800000});
  const GridMapping laea = mapping_of("EPSG:3035");
  EXPECT_EQ(name_of(laea), "lambert_azimuthal_equal_area");
  EXPECT_EQ(number(laea, "longitude_of_projection_origin"), Numbers{10});
  EXPECT_EQ(number(laea, "false_easting"), Numbers{4321000});
  EXPECT_EQ(name_of(mapping_of("EPSG:5070")), "albers_conical_equal_area");
}

TEST(GridMapping, of_a_projection_that_cf_lacks_is_its_wkt_alone) {
  const GridMapping swiss = mapping_of("EPSG:2056");
  EXPECT_EQ(name_of(swiss), "");
  EXPECT_EQ(swiss.texts.back().first, "crs_wkt");
  EXPECT_NE(swiss.texts.back().second.find("LV95"), std::string::npos);
}

TEST(GridMapping, of_feet) {
  EXPECT_EQ(mapping_of("EPSG:2256").unit, "0.3048 m");
}

}  // namespace
}  // namespace thiessen
