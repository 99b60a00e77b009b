#include "gdal/rasters/raster_source.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"

namespace thiessen {
namespace {

class RasterSources : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("thiessen-rasters-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
         testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string written(const std::string& name, const std::string& text) const {
    const std::string file = (folder_ / name).string();
    std::ofstream(file) << text;
    return file;
  }
  static std::string fault_of(const std::string& file) {
    try {
      const RasterSource source(file);
    } catch (const Error& error) {
      return error.messages().front().text.plain();
    }
    return {};
  }

 private:
  std::filesystem::path folder_;
};

constexpr const char* grid =
    "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 50\ncellsize 10\nNODATA_value -9\n1 2 3\n4 -9 6\n";

constexpr const char* map_service = R"(<GDAL_WMS>
<Service name="TMS"><ServerUrl>http://127.0.0.1:9/${z}/${x}/${y}.png</ServerUrl></Service>
<DataWindow><UpperLeftX>0</UpperLeftX><UpperLeftY>1</UpperLeftY><LowerRightX>1</LowerRightX>
<LowerRightY>0</LowerRightY><TileLevel>1</TileLevel></DataWindow>
<Projection>EPSG:4326</Projection><BandsCount>1</BandsCount></GDAL_WMS>)";

using RasterSourcesDeathTest = RasterSources;

// The library may live in a program that registers GDAL's drivers at any time.
TEST_F(RasterSourcesDeathTest, are_of_no_driver_that_asks_other_machines_whoever_registered_it) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const std::string file = written("service.xml", map_service);
  const auto open = [&] {
    fault_of(file);
    GDALAllRegister();
    const bool gdal_opens = GDALDatasetUniquePtr(GDALDataset::Open(file.c_str())) != nullptr;
    const bool is_refused = fault_of(file).starts_with("is no raster that GDAL reads");
    _exit(gdal_opens && is_refused ? 0 : 1);
  };
  EXPECT_EXIT(open(), testing::ExitedWithCode(0), "");
}

TEST_F(RasterSources, are_read_where_they_are_wanted) {
  const RasterSource source(written("grid.asc", grid));
  EXPECT_EQ(source.columns(), 3u);
  EXPECT_EQ(source.rows(), 2u);
  EXPECT_EQ(source.bands(), 1u);
  EXPECT_FALSE(source.crs());
  EXPECT_EQ(source.transform()[0], 100);
  EXPECT_EQ(source.transform()[3], 70);
  EXPECT_EQ(source.transform()[5], -10);
  WindowValues values(4, 2, 1, source.is_wide());
  source.read({1, 0, 2, 2}, values, 2);
  EXPECT_TRUE(std::isnan(values.at(0, 0, 0)));
  EXPECT_EQ(values.at(0, 0, 2), 2);
  EXPECT_EQ(values.at(0, 0, 3), 3);
  EXPECT_TRUE(std::isnan(values.at(0, 1, 2)));
  EXPECT_EQ(values.at(0, 1, 3), 6);
}

// Stored numbers that stand for others: 0.5 x 4 + 10.
TEST_F(RasterSources, know_scales_and_offsets) {
  written("grid.asc", grid);
  const RasterSource source(written(
      "scaled.vrt",
      "<VRTDataset rasterXSize=\"3\" rasterYSize=\"2\"><GeoTransform>0,1,0,0,0,-1</GeoTransform>"
      "<VRTRasterBand dataType=\"Int16\" band=\"1\"><Offset>10</Offset><Scale>0.5</Scale>"
      "<SimpleSource><SourceFilename relativeToVRT=\"1\">grid.asc</SourceFilename>"
      "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>"));
  WindowValues values(1, 1, 1, source.is_wide());
  source.read({0, 1, 1, 1}, values, 0);
  EXPECT_EQ(values.at(0, 0, 0), 12);
}

TEST_F(RasterSources, that_are_none_are_refused) {
  EXPECT_EQ(fault_of("no such file.tif"), "No such file or directory");
  EXPECT_EQ(fault_of(""), "the file's name is empty");
  EXPECT_EQ(fault_of(written("text.txt", "no raster")).substr(0, 29),
            "is no raster that GDAL reads");
  EXPECT_EQ(fault_of("/vsicurl/http://localhost/n.tif"), "No such file or directory");
}

}  // namespace
}  // namespace thiessen
