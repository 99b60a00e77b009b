#include "files/normals/gauge_elevations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "files/normals/mountain_study.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

GaugeElevations found_in(MountainStudy& given, const std::string& raster) {
  const Study& study = given.made();
  std::optional<RasterGround> ground;
  if (!raster.empty()) ground.emplace(raster, study, *given.files, given.warnings);
  return elevations_of_gauges(study, *given.files, ground ? &*ground : nullptr, true,
                              given.warnings);
}

double in_feet(double x, double y) {
  return MountainStudy::ground(x, y) / 0.3048;
}

/// A raster whose band names its unit.
std::string in_unit(const MountainStudy& given, const std::string& unit) {
  given.raster(in_feet, "pixels.asc");
  return given.folder.write(
      "dem.vrt",
      "<VRTDataset rasterXSize=\"8\" rasterYSize=\"8\"><GeoTransform>0, 1, 0, 8, 0, -1"
      "</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"><UnitType>" +
          unit +
          "</UnitType><SimpleSource><SourceFilename relativeToVRT=\"1\">pixels.asc</SourceFilename>"
          "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>");
}

TEST(GaugeElevations, are_of_the_field) {
  MountainStudy given;
  const GaugeElevations found = found_in(given, "");
  EXPECT_DOUBLE_EQ(found.of_stations[0], MountainStudy::ground(1.1, 0.9));
  EXPECT_EQ(found.raster_scale, 1);
  EXPECT_TRUE(given.notices().empty());
}

TEST(GaugeElevations, are_of_the_pixel_where_the_field_has_none) {
  MountainStudy given;
  given.files->station_elevations["g0"] = none;
  const GaugeElevations found = found_in(given, given.raster());
  EXPECT_EQ(found.of_stations[0], MountainStudy::ground(1.5, 0.5));
  EXPECT_DOUBLE_EQ(found.of_stations[1], MountainStudy::ground(3, 0.86));
  ASSERT_EQ(given.notices().size(), 1u);
  EXPECT_EQ(given.notices()[0],
            "the elevation of its pixel there is that of station 'g0', for 'elev' of s.csv is "
            "empty");
}

TEST(GaugeElevations, are_of_the_pixels_where_there_is_no_field) {
  MountainStudy given;
  given.files->elevation_field.clear();
  given.files->station_elevations.clear();
  EXPECT_EQ(found_in(given, given.raster()).of_stations[0], MountainStudy::ground(1.5, 0.5));
  ASSERT_EQ(given.notices().size(), 1u);
  EXPECT_EQ(given.notices()[0],
            "the elevation of its pixel there is that of each station, for s.csv has no field of "
            "them (elev, elevation, z, alt, altitude)");
}

TEST(GaugeElevations, that_nothing_tells_are_named) {
  MountainStudy given;
  given.files->station_elevations["g0"] = none;
  EXPECT_EQ(MountainStudy::faults_of([&] { found_in(given, ""); }),
            std::vector<std::string>{"station 'g0' has no elevation in 'elev'"});
  MountainStudy hole;
  hole.files->station_elevations["g0"] = none;
  const std::string raster = hole.raster(
      [](double x, double y) { return x < 2 && y < 1 ? -9999 : MountainStudy::ground(x, y); });
  EXPECT_EQ(MountainStudy::faults_of([&] { found_in(hole, raster); }),
            std::vector<std::string>{"station 'g0' has no elevation in 'elev', and " + raster +
                                     " has none where it stands"});
}

TEST(GaugeElevations, at_one_place_are_one) {
  MountainStudy given;
  given.add_station("beside", given.files->stations[0].position, none);
  given.add_station("above", given.files->stations[0].position,
                    MountainStudy::ground(1.1, 0.9) + 20);
  const GaugeElevations found = found_in(given, "");
  EXPECT_DOUBLE_EQ(found.of_stations[0], MountainStudy::ground(1.1, 0.9) + 10);
  EXPECT_EQ(found.of_stations[16], found.of_stations[0]);
  EXPECT_EQ(found.of_stations[17], found.of_stations[0]);
}

TEST(GaugeElevations, in_feet_beside_metres_are_refused) {
  MountainStudy given;
  for (auto& [id, elevation] : given.files->station_elevations) elevation /= 0.3048;
  const std::string raster = given.raster();
  EXPECT_EQ(MountainStudy::faults_of([&] { found_in(given, raster); }),
            std::vector<std::string>{"the elevations in 'elev' are 3.28 times those of " + raster +
                                     ": they are in feet, and the raster's in metres"});
  MountainStudy other;
  const std::string feet = other.raster(in_feet);
  EXPECT_EQ(MountainStudy::faults_of([&] { found_in(other, feet); }),
            std::vector<std::string>{"its elevations are 3.28 times those in 'elev' of s.csv: they "
                                     "are in feet, and the stations' in metres"});
}

TEST(GaugeElevations, of_a_raster_that_says_feet_are_brought_to_metres) {
  MountainStudy given;
  given.files->station_elevations["g0"] = none;
  const GaugeElevations found = found_in(given, in_unit(given, "ft"));
  EXPECT_NEAR(found.of_stations[0], MountainStudy::ground(1.5, 0.5), 1e-4);
  EXPECT_EQ(found.raster_scale, 0.3048);
  EXPECT_EQ(given.notices().at(0), "its elevations are brought from feet to metres");
}

TEST(GaugeElevations, stay_in_feet_where_all_are) {
  MountainStudy given;
  for (auto& [id, elevation] : given.files->station_elevations) elevation /= 0.3048;
  EXPECT_EQ(found_in(given, in_unit(given, "US survey foot")).raster_scale, 1);
  EXPECT_EQ(given.notices().at(0), "its elevations are in feet, as are those of s.csv");
}

}  // namespace
}  // namespace thiessen
