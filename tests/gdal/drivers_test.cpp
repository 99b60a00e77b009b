#include "gdal/drivers.h"

#include <cpl_http.h>
#include <cpl_string.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "gdal/gdal_errors.h"

namespace thiessen {
namespace {

TEST(Drivers, are_those_that_are_promised) {
  start_gdal();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (const char* name :
       {"GeoJSON", "GPKG", "ESRI Shapefile", "FlatGeobuf", "LIBKML", "XLSX", "ODS"})
    EXPECT_NE(drivers.GetDriverByName(name), nullptr) << name;
}

TEST(Drivers, fetch_nothing_over_a_network) {
  start_gdal();
  const GdalErrors errors;
  CPLHTTPResult* answer = CPLHTTPFetch("http://127.0.0.1:9/", nullptr);
  ASSERT_NE(answer, nullptr);
  EXPECT_NE(answer->nStatus, 0);
  EXPECT_STREQ(answer->pszErrBuf, "nothing is fetched over a network");
  CPLHTTPDestroyResult(answer);
}

/// Starts GDAL in a process of its own, as it starts once in each, and tells by its exit status
/// whether it is as it should be.
template <typename IsRight>
[[noreturn]] void start_and_exit(IsRight is_right) {
  start_gdal();
  _exit(is_right() ? 0 : 1);
}

class DriversDeathTest : public testing::Test {
 protected:
  DriversDeathTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(DriversDeathTest, the_users_settings_of_gdal_and_proj_have_no_effect_and_others_stay) {
  const auto start = [] {
    for (const char* name : {"GDAL_DATA_TEST", "OGR_GEOJSON_MAX_OBJ_SIZE", "CPL_DEBUG",
                             "PROJ_NETWORK", "SHAPE_ENCODING", "CENTER_LONG"})
      setenv(name, "1", 1);
    setenv("MY_GDAL_PATH", "1", 1);
    start_and_exit([] {
      for (const char* name : {"GDAL_DATA_TEST", "OGR_GEOJSON_MAX_OBJ_SIZE", "CPL_DEBUG",
                               "PROJ_NETWORK", "SHAPE_ENCODING", "CENTER_LONG"})
        if (getenv(name) != nullptr) return false;
      return getenv("MY_GDAL_PATH") != nullptr;
    });
  };
  EXPECT_EXIT(start(), testing::ExitedWithCode(0), "");
}

TEST_F(DriversDeathTest, drivers_that_read_other_files_by_name_are_not_started) {
  const auto start = [] {
    start_and_exit([] {
      for (const char* name : {"OGR_VRT", "WFS", "CSV", "Memory", "HTTP", "GMLAS"})
        if (GetGDALDriverManager()->GetDriverByName(name) != nullptr) return false;
      return true;
    });
  };
  EXPECT_EXIT(start(), testing::ExitedWithCode(0), "");
}

TEST_F(DriversDeathTest, what_rasters_need_holds_none_that_asks_other_machines) {
  const auto start = [] {
    register_local_drivers();
    start_and_exit([] {
      GDALDriverManager& drivers = *GetGDALDriverManager();
      for (const char* name : {"WMS", "WFS", "WCS", "HTTP", "PostGISRaster", "Elasticsearch"})
        if (drivers.GetDriverByName(name) != nullptr) return false;
      return drivers.GetDriverByName("GTiff") != nullptr &&
             drivers.GetDriverByName("netCDF") != nullptr;
    });
  };
  EXPECT_EXIT(start(), testing::ExitedWithCode(0), "");
}

std::vector<std::string> names_of_drivers() {
  std::vector<std::string> names;
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (int i = 0; i < drivers.GetDriverCount(); ++i)
    names.emplace_back(drivers.GetDriver(i)->GetDescription());
  std::sort(names.begin(), names.end());
  return names;
}

// The library may live in a program that uses GDAL itself, and has datasets open.
TEST_F(DriversDeathTest, those_that_another_registered_first_stay) {
  const auto start = [] {
    GDALAllRegister();
    const std::vector<std::string> before = names_of_drivers();
    register_local_drivers();
    const std::vector<std::string> after = names_of_drivers();
    _exit(std::includes(after.begin(), after.end(), before.begin(), before.end()) ? 0 : 1);
  };
  EXPECT_EXIT(start(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace thiessen
