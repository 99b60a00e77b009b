#include "gdal/rasters/geotiff_grid.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/complaints.h"
#include "base/program_output.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

RasterOutput output_to(const std::string& path, int columns, int rows) {
  RasterOutput output;
  output.grid = {{0, 0}, 1, columns, rows};
  output.path = path;
  output.made_by.unit = "mm";
  return output;
}

/// Each pixel's column + 1000 x its row + so much.
std::vector<float> pixels_of(const RasterOutput& output, float more) {
  std::vector<float> pixels;
  for (int row = 0; row < output.grid.rows; ++row) {
    for (int column = 0; column < output.grid.columns; ++column)
      pixels.push_back(static_cast<float>(column + 1000 * row) + more);
  }
  return pixels;
}

// 600 rows are three rows of tiles, of which the last is not whole.
TEST(GeoTiffGrid, has_a_band_a_step_with_the_pixels_where_they_were) {
  const TemporaryFolder folder;
  const RasterOutput output = output_to(folder.path("r.tif"), 300, 600);
  const std::vector<std::string> times{"2013-08-01", "2.8.2013"};
  GeoTiffGrid grid(output, times);
  grid.add(pixels_of(output, 0));
  grid.add(pixels_of(output, 0.5));
  const std::vector<EncodedFile> files = grid.finish();
  ASSERT_GE(files.size(), 1U);
  EXPECT_EQ(files[0].name, output.path);
  folder.write("r.tif", files[0].bytes);
  std::string places;
  std::string wanted;
  for (const auto& [column, row] :
       {std::pair{0, 0}, {299, 0}, {255, 255}, {256, 256}, {7, 511}, {7, 512}, {299, 599}}) {
    places += std::to_string(column) + " " + std::to_string(row) + "\\n";
    const std::string value = std::to_string(column + 1000 * row);
    wanted += value + "\n" + value + ".5\n";
  }
  EXPECT_EQ(
      program_output("printf '" + places + "' | gdallocationinfo -valonly '" + output.path + "'"),
      wanted);
  const std::string info = program_output("gdalinfo '" + output.path + "'");
  EXPECT_TRUE(contains(info, "Description = 2013-08-01")) << info;
  EXPECT_TRUE(contains(info, "Description = 2.8.2013"));
  EXPECT_TRUE(contains(info, "time=2.8.2013"));
  EXPECT_TRUE(contains(info, "Unit Type: mm"));
  EXPECT_TRUE(contains(info, "NoData Value=nan"));
}

// A pipe has it from memory, a file is written as the steps come: then no byte is held.
TEST(GeoTiffGrid, law_1_has_the_same_bytes_on_the_disk_as_in_memory) {
  for (const Compression compression : {Compression::none, Compression::deflate}) {
    const TemporaryFolder folder;
    RasterOutput output = output_to(folder.path("out/r.tif"), 300, 600);
    output.compression = compression;
    const std::vector<std::string> times{"a", "b"};
    const auto written = [&] {
      GeoTiffGrid grid(output, times);
      grid.add(pixels_of(output, 0));
      grid.add(pixels_of(output, 0.5));
      return grid.finish();
    };
    const std::string in_memory = written().at(0).bytes;
    output.file_on_disk = folder.path("r.tif");
    const std::vector<EncodedFile> files = written();
    EXPECT_EQ(files.at(0).name, output.path);
    EXPECT_EQ(files.at(0).bytes, "");
    EXPECT_TRUE(folder.read("r.tif") == in_memory);
  }
}

TEST(GeoTiffGrid, of_more_steps_than_its_format_holds_is_an_error_before_anything_is_written) {
  const std::vector<std::string> times(65'536, "1");
  const RasterOutput output = output_to("r.tif", 10'000'000, 10'000'000);
  EXPECT_EQ(complaint_of([&] { GeoTiffGrid(output, times); }),
            "r.tif: a GeoTIFF has up to 65535 bands, and there are 65536 time steps | a .nc holds "
            "any number; 'from' and 'to' choose some");
}

}  // namespace
}  // namespace thiessen
