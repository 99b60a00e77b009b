#include "gdal/output/raster_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/complaints.h"
#include "base/program_output.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

OwnerRows rows_of(const std::vector<std::int32_t>& owners, int columns) {
  return [&owners, columns](int row, int count) {
    return std::span(owners).subspan(static_cast<std::size_t>(row * columns),
                                     static_cast<std::size_t>(count * columns));
  };
}

const PixelGrid grid = {{500000, 5500000}, 25, 300, 2};

TEST(RasterFile, owners_come_back_with_their_ids) {
  std::vector<std::int32_t> owners(600, 0);
  owners[0] = 2;
  owners[299] = 1;
  owners[599] = 2;
  const TemporaryFolder folder;
  const auto files =
      owners_geotiff(grid, rows_of(owners, 300), {"007", "a<b"},
                     Crs::from_text("EPSG:32633", setting("crs")), {}, folder.path("map.tif"), 1);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, folder.path("map.tif"));
  EXPECT_EQ(files[1].name, folder.path("map.tif.aux.xml"));
  for (const EncodedFile& file : files)
    folder.write(file.name.substr(folder.path().size() + 1), file.bytes);
  const std::string info = program_output("gdalinfo '" + folder.path("map.tif") + "'");
  EXPECT_TRUE(contains(info, "Size is 300, 2")) << info;
  EXPECT_TRUE(contains(info, "Origin = (500000.0"));
  EXPECT_TRUE(contains(info, "Pixel Size = (25.0"));
  EXPECT_TRUE(contains(info, "ID[\"EPSG\",32633]"));
  EXPECT_TRUE(contains(info, "COMPRESSION=DEFLATE"));
  EXPECT_TRUE(contains(info, "Type=Int32"));
  EXPECT_TRUE(contains(info, "<F>007</F>"));
  EXPECT_TRUE(contains(info, "<F>a&lt;b</F>"));
  const auto value = [&](const std::string& pixel) {
    return program_output("gdallocationinfo -valonly '" + folder.path("map.tif") + "' " + pixel);
  };
  EXPECT_EQ(value("0 0"), "2\n");
  EXPECT_EQ(value("299 0"), "1\n");
  EXPECT_EQ(value("299 1"), "2\n");
  EXPECT_EQ(value("1 1"), "0\n");
}

TEST(RasterFile, rainfall_is_the_owner_s_and_not_a_number_outside) {
  std::vector<std::int32_t> owners(600, 0);
  owners[301] = 2;
  owners[302] = 1;
  const std::vector<double> rainfall{0.1, 12.5};
  const TemporaryFolder folder;
  const auto files = rainfall_geotiff(grid, rows_of(owners, 300), rainfall, std::nullopt, {},
                                      folder.path("map.tif"), 2);
  ASSERT_EQ(files.size(), 1U);
  folder.write("map.tif", files[0].bytes);
  const auto value = [&](const std::string& pixel) {
    return program_output("gdallocationinfo -valonly '" + folder.path("map.tif") + "' " + pixel);
  };
  EXPECT_EQ(value("1 1"), "12.5\n");
  EXPECT_EQ(value("2 1"), "0.100000001490116\n");
  EXPECT_EQ(value("3 1"), "nan\n");
  const std::string info = program_output("gdalinfo '" + folder.path("map.tif") + "'");
  EXPECT_TRUE(contains(info, "NoData Value=nan")) << info;
  EXPECT_TRUE(contains(info, "Type=Float32"));
}

TEST(RasterFile, the_same_pixels_make_the_same_bytes) {
  const PixelGrid large{{0, 0}, 1, 1000, 1100};
  std::vector<std::int32_t> owners(1'100'000);
  for (std::size_t i = 0; i < owners.size(); ++i)
    owners[i] = static_cast<std::int32_t>(i % 977 * (i / 1000) % 1013);
  const std::vector<double> rainfall(1013, 1);
  const auto bytes = [&](unsigned threads) {
    return owners_geotiff(large, rows_of(owners, 1000), {"a"}, Crs::wgs84(), {}, "a.tif", threads)
        .at(0)
        .bytes;
  };
  const std::string one = bytes(1);
  EXPECT_TRUE(one == bytes(1));
  EXPECT_TRUE(one == bytes(2));
  EXPECT_TRUE(one == bytes(5));
  EXPECT_TRUE(rainfall_geotiff(large, rows_of(owners, 1000), rainfall, Crs::wgs84(), {}, "a.tif", 1)
                  .at(0)
                  .bytes ==
              rainfall_geotiff(large, rows_of(owners, 1000), rainfall, Crs::wgs84(), {}, "b.tif", 3)
                  .at(0)
                  .bytes);
}

}  // namespace
}  // namespace thiessen
