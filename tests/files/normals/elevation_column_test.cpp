#include "files/normals/elevation_column.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "files/places/basins_file.h"
#include "files/places/stations_file.h"

namespace thiessen {
namespace {

StationsFile stations(const std::string& text, const std::optional<std::string>& field) {
  const TemporaryFolder folder;
  StationsRequest wanted;
  wanted.source.file = folder.write("s.csv", text);
  wanted.elevation_field = field;
  Warnings warnings;
  return read_stations(wanted, warnings);
}

BasinsFile basins(const std::string& rows, const std::optional<std::string>& field) {
  const TemporaryFolder folder;
  BasinsRequest wanted;
  wanted.source.file = folder.write("b.csv", "id,ELEV,WKT\n" + rows);
  wanted.source.crs_setting = "basins_crs";
  wanted.id = "id";
  wanted.elevation_field = field;
  Warnings warnings;
  return read_basins(wanted, warnings);
}

constexpr const char* square = "\"POLYGON((0 0,1 0,1 1,0 1,0 0))\"\n";

TEST(ElevationColumn, is_found_by_name_or_as_it_is_named) {
  const std::string text = "id,lon,lat,altitude,Elevation,top\na,7,46,1,-2.5,3\n";
  const StationsFile found = stations(text, "");
  EXPECT_EQ(found.elevation_field, "Elevation") << "elev and elevation come before altitude";
  EXPECT_EQ(found.elevations.at("a"), -2.5);
  EXPECT_EQ(stations(text, "TOP").elevations.at("a"), 3);
  EXPECT_TRUE(stations(text, std::nullopt).elevations.empty());
  EXPECT_EQ(stations("id,lon,lat\na,7,46\n", "").elevation_field, "");
  EXPECT_NE(complaint_of([] { stations("id,lon,lat\na,7,46\n", "high"); }).find("no field 'high'"),
            std::string::npos);
}

TEST(ElevationColumn, has_none_where_it_is_empty_or_a_code) {
  const StationsFile found = stations(
      "id,lon,lat,z\na,7,46,\nb,7.1,46,-999.9\nc,7.2,46,NA\nd,7.3,46,-9999\ne,7.4,46,-430\n", "");
  for (const char* id : {"a", "b", "c", "d"})
    EXPECT_TRUE(std::isnan(found.elevations.at(id))) << id;
  EXPECT_EQ(found.elevations.at("e"), -430) << "the Dead Sea";
}

TEST(ElevationColumn, holds_numbers) {
  EXPECT_NE(complaint_of([] {
              stations("id,lon,lat,z\na,7,46,high\n", "");
            }).find("station 'a' has an elevation in 'z' that is no number: 'high'"),
            std::string::npos);
}

TEST(ElevationColumn, of_a_basin_is_one) {
  const std::string row = std::string("B,500,") + square;
  EXPECT_EQ(basins(row, "elev").elevations.at("B"), 500);
  EXPECT_EQ(basins(row + "B,500,\"POLYGON((2 0,3 0,3 1,2 1,2 0))\"\n", "elev").basins.size(), 1u);
  EXPECT_NE(complaint_of([&] {
              basins(row + "B,600,\"POLYGON((2 0,3 0,3 1,2 1,2 0))\"\n", "elev");
            }).find("has another elevation in another of its features"),
            std::string::npos);
}

TEST(ElevationColumn, says_what_else_there_is_where_basins_lack_it) {
  try {
    basins(std::string("B,500,") + square, "level");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.messages().front().hint.plain(),
              "'elevation' RASTER has the ground's elevations, and basins need none then");
  }
}

}  // namespace
}  // namespace thiessen
