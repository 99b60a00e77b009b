#include "io/raster_file.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <limits>
#include <memory>

#include "base/temporary_folder.h"
#include "io/complaints.h"

namespace thiessen {
namespace {

/// What another program prints.
std::string output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) return {};
  std::string text;
  std::array<char, 4096> buffer;
  while (const std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe.get())) {
    text.append(buffer.data(), count);
  }
  return text;
}

const PixelGrid grid = {{500000, 5500000}, 25, 300, 2};

TEST(RasterFile, owners_come_back_with_their_ids) {
  std::vector<std::int32_t> owners(600, 0);
  owners[0] = 2;
  owners[299] = 1;
  owners[599] = 2;
  const TemporaryFolder folder;
  const auto files = owners_geotiff(grid, owners, {"007", "a<b"},
                                    Crs::from_text("EPSG:32633", "--crs"), folder.path("map.tif"));
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, folder.path("map.tif"));
  EXPECT_EQ(files[1].name, folder.path("map.tif.aux.xml"));
  for (const EncodedFile& file : files)
    folder.write(file.name.substr(folder.path().size() + 1), file.bytes);
  const std::string info = output_of("gdalinfo '" + folder.path("map.tif") + "'");
  EXPECT_TRUE(contains(info, "Size is 300, 2")) << info;
  EXPECT_TRUE(contains(info, "Origin = (500000.0"));
  EXPECT_TRUE(contains(info, "Pixel Size = (25.0"));
  EXPECT_TRUE(contains(info, "ID[\"EPSG\",32633]"));
  EXPECT_TRUE(contains(info, "COMPRESSION=DEFLATE"));
  EXPECT_TRUE(contains(info, "Type=Int32"));
  EXPECT_TRUE(contains(info, "<F>007</F>"));
  EXPECT_TRUE(contains(info, "<F>a&lt;b</F>"));
  const auto value = [&](const std::string& pixel) {
    return output_of("gdallocationinfo -valonly '" + folder.path("map.tif") + "' " + pixel);
  };
  EXPECT_EQ(value("0 0"), "2\n");
  EXPECT_EQ(value("299 0"), "1\n");
  EXPECT_EQ(value("299 1"), "2\n");
  EXPECT_EQ(value("1 1"), "0\n");
}

TEST(RasterFile, rainfall_is_not_a_number_outside) {
  std::vector<float> rainfall(600, std::numeric_limits<float>::quiet_NaN());
  rainfall[301] = 12.5F;
  const TemporaryFolder folder;
  const auto files = rainfall_geotiff(grid, rainfall, std::nullopt, folder.path("map.tif"));
  ASSERT_EQ(files.size(), 1U);
  folder.write("map.tif", files[0].bytes);
  EXPECT_EQ(output_of("gdallocationinfo -valonly '" + folder.path("map.tif") + "' 1 1"), "12.5\n");
  const std::string info = output_of("gdalinfo '" + folder.path("map.tif") + "'");
  EXPECT_TRUE(contains(info, "NoData Value=nan")) << info;
  EXPECT_TRUE(contains(info, "Type=Float32"));
}

TEST(RasterFile, the_same_pixels_make_the_same_bytes) {
  const std::vector<float> rainfall(600, 1);
  EXPECT_TRUE(rainfall_geotiff(grid, rainfall, Crs::wgs84(), "a.tif").at(0).bytes ==
              rainfall_geotiff(grid, rainfall, Crs::wgs84(), "b.tif").at(0).bytes);
}

}  // namespace
}  // namespace thiessen
