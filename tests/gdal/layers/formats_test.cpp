#include "gdal/layers/formats.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

/// The drivers that a name leads to, with a blank between them; "csv" where none, "?" where the
/// name says nothing.
std::string drivers_of(const std::string& name) {
  const InputFormat* const format = format_by_extension(name);
  if (format == nullptr) return "?";
  std::string drivers;
  for (const char* driver : format->drivers)
    drivers += (drivers.empty() ? "" : " ") + std::string(driver);
  return drivers.empty() ? "csv" : drivers;
}

TEST(Formats, are_known_by_the_extension_of_the_files) {
  EXPECT_EQ(drivers_of("a.geojson"), "GeoJSON");
  EXPECT_EQ(drivers_of("a.json"), "GeoJSON");
  EXPECT_EQ(drivers_of("a.gpkg"), "GPKG");
  EXPECT_EQ(drivers_of("a.fgb"), "FlatGeobuf");
  EXPECT_EQ(drivers_of("a.kml"), "LIBKML KML") << "the second where the first is not built in";
  EXPECT_EQ(drivers_of("a.kmz"), "LIBKML");
  for (const char* shapefile : {"a.shp", "a.dbf", "a.shz"})
    EXPECT_EQ(drivers_of(shapefile), "ESRI Shapefile") << shapefile;
  EXPECT_EQ(drivers_of("a.xlsx"), "XLSX");
  EXPECT_EQ(drivers_of("a.xlsm"), "XLSX");
  EXPECT_EQ(drivers_of("a.xls"), "XLS");
  EXPECT_EQ(drivers_of("a.ods"), "ODS");
  for (const char* text : {"a.csv", "a.tsv", "a.txt"}) EXPECT_EQ(drivers_of(text), "csv") << text;
}

TEST(Formats, are_known_in_any_case_in_any_locale) {
  EXPECT_EQ(drivers_of("RAIN.XLSX"), "XLSX");
  EXPECT_EQ(drivers_of("B.GeoJSON"), "GeoJSON");
  EXPECT_EQ(drivers_of("B.SHP.ZIP"), "ESRI Shapefile") << "a Turkish i has no dot";
}

TEST(Formats, the_longest_extension_tells) {
  EXPECT_EQ(drivers_of("a.shp.zip"), "ESRI Shapefile");
  EXPECT_EQ(drivers_of("a.zip"), "?") << "an archive of anything";
  EXPECT_EQ(drivers_of("a.geojson.csv"), "csv");
  EXPECT_EQ(format_by_extension("a.shp.zip")->extension, ".shp.zip");
}

TEST(Formats, are_told_by_nothing_but_the_end_of_the_name) {
  for (const char* name : {"", "csv", "a.csv.gz", "a.csv/b", "a.shp ", "acsv", "a.geojsonx"})
    EXPECT_EQ(drivers_of(name), "?") << name;
  EXPECT_EQ(drivers_of(".csv"), "csv");
}

TEST(Formats, of_spreadsheets_are_known) {
  for (const char* file : {"a.xlsx", "a.XLS", "a.ods", "a.xlsm"})
    EXPECT_TRUE(is_spreadsheet(*format_by_extension(file))) << file;
  for (const char* file : {"a.csv", "a.txt", "a.gpkg"})
    EXPECT_FALSE(is_spreadsheet(*format_by_extension(file))) << file;
}

}  // namespace
}  // namespace thiessen
