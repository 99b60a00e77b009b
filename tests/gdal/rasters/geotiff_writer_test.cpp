#include "gdal/rasters/geotiff_writer.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/complaints.h"
#include "base/interrupt.h"
#include "base/program_output.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Pixels = GeoTiffWriter::Pixels;

RasterOutput output_to(const std::string& path, int columns, int rows) {
  RasterOutput output;
  output.grid = {{0, 0}, 1, columns, rows};
  output.path = path;
  return output;
}

/// The bytes of numbers from 1 on, written so many rows at a time.
std::string bytes_of(const RasterOutput& output, int rows_at_once) {
  const auto columns = static_cast<std::size_t>(output.grid.columns);
  std::vector<std::int32_t> numbers(columns * static_cast<std::size_t>(output.grid.rows));
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::int32_t>(i + 1);
  GeoTiffWriter writer(output, Pixels::numbers, 1);
  for (int row = 0; row < output.grid.rows; row += rows_at_once) {
    const int rows = std::min(rows_at_once, output.grid.rows - row);
    writer.write(1, row, rows, numbers.data() + static_cast<std::size_t>(row) * columns);
  }
  return writer.finish().at(0).bytes;
}

std::string info_of(const std::string& bytes) {
  const TemporaryFolder folder;
  return program_output("gdalinfo '" + folder.write("r.tif", bytes) + "'");
}

/// What stands in GDAL's memory.
int files_in_memory() {
  return CPLStringList(VSIReadDirRecursive("/vsimem/")).Count();
}

TEST(GeoTiffWriter, writes_in_rows_of_square_tiles_which_compress_best) {
  const RasterOutput output = output_to("r.tif", 600, 10);
  GeoTiffWriter writer(output, Pixels::numbers, 1);
  EXPECT_EQ(writer.rows_of_tiles(), 256);
  EXPECT_TRUE(contains(info_of(bytes_of(output, 10)), "Block=256x256 Type=Int32"));
}

TEST(GeoTiffWriter, has_0_for_no_number_and_what_is_not_a_number_for_no_rainfall) {
  const RasterOutput output = output_to("r.tif", 2, 1);
  EXPECT_TRUE(contains(info_of(bytes_of(output, 1)), "NoData Value=0\n"));
  GeoTiffWriter writer(output, Pixels::rainfall, 1);
  const std::vector<float> rainfall{0, 1};
  writer.write(1, 0, 1, rainfall.data());
  const std::string info = info_of(writer.finish().at(0).bytes);
  EXPECT_TRUE(contains(info, "NoData Value=nan")) << info;
  EXPECT_TRUE(contains(info, "Type=Float32"));
}

TEST(GeoTiffWriter, law_1_bytes_do_not_depend_on_the_threads) {
  RasterOutput output = output_to("r.tif", 1000, 700);
  output.has_overviews = true;
  const std::string one = bytes_of(output, 256);
  output.threads = 3;
  EXPECT_TRUE(bytes_of(output, 256) == one);
}

// Whole tiles are not written twice, so that nothing is left over from the first time.
TEST(GeoTiffWriter, law_2_pixels_do_not_depend_on_the_rows_that_are_written_at_once) {
  const RasterOutput output = output_to("r.tif", 300, 520);
  const TemporaryFolder folder;
  const auto sum = [&](const std::string& bytes) {
    return program_output("gdalinfo -checksum '" + folder.write("r.tif", bytes) +
                          "' | grep Checksum");
  };
  const std::string whole = sum(bytes_of(output, 520));
  EXPECT_TRUE(contains(whole, "Checksum=")) << whole;
  EXPECT_EQ(sum(bytes_of(output, 256)), whole);
  EXPECT_EQ(sum(bytes_of(output, 100)), whole);
}

// Each is half of the one before, rounded up, down to one that a tile of 256 holds.
TEST(GeoTiffWriter, halves_its_overviews_until_a_tile_holds_one) {
  const auto overviews = [](int columns, int rows) {
    RasterOutput output = output_to("r.tif", columns, rows);
    output.has_overviews = true;
    const std::string info = info_of(bytes_of(output, rows));
    const std::size_t at = info.find("Overviews: ");
    return at == std::string::npos ? "" : info.substr(at + 11, info.find('\n', at) - at - 11);
  };
  EXPECT_EQ(overviews(256, 256), "");
  EXPECT_EQ(overviews(257, 3), "129x2");
  EXPECT_EQ(overviews(512, 512), "256x256");
  EXPECT_EQ(overviews(3, 1025), "2x513, 1x257, 1x129");
}

TEST(GeoTiffWriter, law_3_leaves_nothing_in_memory_whether_it_is_finished_or_not) {
  const int before = files_in_memory();
  const RasterOutput output = output_to("r.tif", 300, 300);
  bytes_of(output, 300);
  EXPECT_EQ(files_in_memory(), before);
  {
    const GeoTiffWriter unfinished(output, Pixels::rainfall, 3);
    EXPECT_GT(files_in_memory(), before);
  }
  EXPECT_EQ(files_in_memory(), before);
}

TEST(GeoTiffWriter, stops_where_a_signal_came) {
  watch_for_interrupts();
  const RasterOutput output = output_to("r.tif", 2, 1);
  GeoTiffWriter writer(output, Pixels::rainfall, 1);
  const std::vector<float> rainfall{0, 1};
  std::raise(SIGINT);
  EXPECT_THROW(writer.write(1, 0, 1, rainfall.data()), Interrupted);
  forget_interrupt();
  EXPECT_NO_THROW(writer.write(1, 0, 1, rainfall.data()));
}

TEST(GeoTiffWriter, of_a_size_that_gdal_cannot_write_is_an_error_by_the_files_name) {
  const RasterOutput output = output_to("r.tif", 0, 0);
  EXPECT_TRUE(contains(complaint_of([&] { GeoTiffWriter(output, Pixels::numbers, 1); }),
                       "r.tif: GDAL cannot write it: "));
}

}  // namespace
}  // namespace thiessen
