#include "cli/outputs/rasters/raster_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/program_output.h"
#include "base/temporary_folder.h"
#include "cli/outputs/given_inputs.h"
#include "cli/outputs/provenance_of.h"

namespace thiessen::cli {
namespace {

/// A raster of these inputs, as another program reads it.
class WrittenRaster {
 public:
  WrittenRaster(const GivenInputs& given, const GaugeReadings* readings, double resolution) {
    RasterOutput output;
    output.grid = raster_grid(given.inputs, resolution);
    output.crs = given.inputs.study().output_crs();
    output.made_by = provenance_of(given.inputs, given.options(), readings, "mm");
    output.path = folder_.path("r.tif");
    ShownRaster shown;
    shown.readings = readings;
    Warnings warnings;
    for (const EncodedFile& file : raster_of(given.inputs, shown, output, warnings))
      folder_.write(file.name.substr(folder_.path().size() + 1), file.bytes);
  }
  /// The values of pixels, which are given as column and row; one after the other.
  std::string values(const std::string& pixels) const {
    std::string text = program_output("printf '" + pixels + "' | gdallocationinfo -valonly '" +
                                      folder_.path("r.tif") + "'");
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }
  std::string info() const { return program_output("gdalinfo '" + folder_.path("r.tif") + "'"); }

 private:
  TemporaryFolder folder_;
};

// Pixels of 1 in the basin of 10 times 4, whose bisector is x = 4.
TEST(RasterOf, has_the_number_of_the_nearest_station) {
  const WrittenRaster raster(GivenInputs(), nullptr, 1);
  const std::string info = raster.info();
  EXPECT_TRUE(contains(info, "Size is 10, 4")) << info;
  EXPECT_TRUE(contains(info, "<F>B</F>")) << info;
  EXPECT_EQ(raster.values(R"(0 0\n3 3\n4 0\n9 3\n)"), "1 1 2 2 ");
}

TEST(RasterOf, has_the_rainfall_of_the_nearest_gauge_that_reports) {
  const GaugeReadings readings{{std::numeric_limits<double>::quiet_NaN(), 12.5}, "2013-08-01"};
  const WrittenRaster raster(GivenInputs(), &readings, 1);
  EXPECT_EQ(raster.values(R"(0 0\n9 3\n)"), "12.5 12.5 ");
}

TEST(RasterOf, has_2000_pixels_along_its_longer_side_where_nothing_is_said) {
  EXPECT_TRUE(contains(WrittenRaster(GivenInputs(), nullptr, 0).info(), "Size is 2000, 800"));
}

// The study is in the plane of UTM, the files are in degrees, and so is the raster.
TEST(RasterOf, is_in_the_crs_of_the_basins) {
  GivenFiles files = files_in_degrees();
  files.options.insert(files.options.end(), {"--plane", "EPSG:32633"});
  const GivenInputs given(files);
  EXPECT_EQ(given.inputs.study().crs->name(), "EPSG:32633");
  const WrittenRaster raster(given, nullptr, 0.1);
  const std::string info = raster.info();
  EXPECT_TRUE(contains(info, "Size is 10, 10")) << info;
  EXPECT_TRUE(contains(info, "ID[\"EPSG\",4326]")) << info;
  EXPECT_EQ(raster.values(R"(0 9\n9 0\n)"), "1 2 ");
}

// Without basins the area is the stations' extent: in the plane, and taken to their file's degrees.
TEST(RasterOf, without_basins_holds_the_extent_in_the_stations_crs) {
  GivenFiles files;
  files.basins.clear();
  files.stations = "id,lon,lat\nA,15,50\nB,16,50.5\n";
  files.options = {"--plane", "EPSG:32633"};
  const WrittenRaster raster(GivenInputs(files), nullptr, 0.1);
  const std::string info = raster.info();
  EXPECT_TRUE(contains(info, "ID[\"EPSG\",4326]")) << info;
  EXPECT_EQ(raster.values(R"(0 4\n9 1\n)"), "1 2 ") << info;
}

}  // namespace
}  // namespace thiessen::cli
