#include "gdal/rasters/raster_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/complaints.h"
#include "base/program_output.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

template <typename Value>
auto rows_of(const std::vector<Value>& pixels, int columns) {
  return [&pixels, columns](int row, int count) {
    return std::span(pixels).subspan(static_cast<std::size_t>(row * columns),
                                     static_cast<std::size_t>(count * columns));
  };
}

const PixelGrid grid = {{500000, 5500000}, 25, 300, 2};

RasterOutput output_to(const std::string& path, const PixelGrid& pixels = grid) {
  RasterOutput output;
  output.grid = pixels;
  output.crs = Crs::from_text("EPSG:32633", setting("crs"));
  output.path = path;
  return output;
}

/// What gdalinfo says of the GeoTIFF, which is written to the folder.
std::string info_of(const TemporaryFolder& folder, const std::vector<EncodedFile>& files) {
  for (const EncodedFile& file : files)
    folder.write(file.name.substr(folder.path().size() + 1), file.bytes);
  return program_output("gdalinfo '" + folder.path("map.tif") + "'");
}

TEST(RasterFile, owners_come_back_with_their_ids) {
  std::vector<std::int32_t> owners(600, 0);
  owners[0] = 3;
  owners[299] = 1;
  owners[599] = 3;
  const TemporaryFolder folder;
  const auto files = owners_geotiff(output_to(folder.path("map.tif")), rows_of(owners, 300),
                                    {"007", "no pixel", "a<b"});
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, folder.path("map.tif"));
  EXPECT_EQ(files[1].name, folder.path("map.tif.aux.xml"));
  const std::string info = info_of(folder, files);
  EXPECT_TRUE(contains(info, "Size is 300, 2")) << info;
  EXPECT_TRUE(contains(info, "Origin = (500000.0"));
  EXPECT_TRUE(contains(info, "Pixel Size = (25.0"));
  EXPECT_TRUE(contains(info, "ID[\"EPSG\",32633]"));
  EXPECT_TRUE(contains(info, "COMPRESSION=DEFLATE"));
  EXPECT_TRUE(contains(info, "Type=Int32"));
  EXPECT_TRUE(contains(info, "<F>007</F>"));
  EXPECT_TRUE(contains(info, "<F>a&lt;b</F>"));
  EXPECT_FALSE(contains(info, "no pixel"));
  EXPECT_TRUE(contains(info, "Description = station"));
  const auto value = [&](const std::string& pixel) {
    return program_output("gdallocationinfo -valonly '" + folder.path("map.tif") + "' " + pixel);
  };
  EXPECT_EQ(value("0 0"), "3\n");
  EXPECT_EQ(value("299 0"), "1\n");
  EXPECT_EQ(value("299 1"), "3\n");
  EXPECT_EQ(value("1 1"), "0\n");
}

TEST(RasterFile, rainfall_has_its_time_and_unit_and_is_not_a_number_outside) {
  std::vector<float> rainfall(600, std::numeric_limits<float>::quiet_NaN());
  rainfall[301] = 12.5F;
  rainfall[302] = 0.1F;
  const TemporaryFolder folder;
  RasterOutput output = output_to(folder.path("map.tif"));
  output.crs.reset();
  output.made_by.software = "thiessen 9";
  const auto files =
      rainfall_geotiff(output, rows_of(rainfall, 300), {"31.12.2020", "31.12.2020", "mm/h"});
  ASSERT_EQ(files.size(), 1U);
  const std::string info = info_of(folder, files);
  const auto value = [&](const std::string& pixel) {
    return program_output("gdallocationinfo -valonly '" + folder.path("map.tif") + "' " + pixel);
  };
  EXPECT_EQ(value("1 1"), "12.5\n");
  EXPECT_EQ(value("2 1"), "0.100000001490116\n");
  EXPECT_EQ(value("3 1"), "nan\n");
  EXPECT_TRUE(contains(info, "NoData Value=nan")) << info;
  EXPECT_TRUE(contains(info, "Type=Float32"));
  EXPECT_TRUE(contains(info, "Description = 31.12.2020"));
  EXPECT_TRUE(contains(info, "time=31.12.2020"));
  EXPECT_TRUE(contains(info, "units=mm/h"));
  EXPECT_TRUE(contains(info, "Unit Type: mm/h"));
  EXPECT_TRUE(contains(info, "TIFFTAG_SOFTWARE=thiessen 9"));
}

TEST(RasterFile, owners_have_the_colours_that_are_chosen_when_all_pixels_are_known) {
  const std::vector<std::int32_t> owners(600, 2);
  const TemporaryFolder folder;
  int asked = 0;
  const auto files =
      owners_geotiff(output_to(folder.path("map.tif")), rows_of(owners, 300), {"A", "B"}, [&] {
        ++asked;
        return std::vector<Colour>{{1, 2, 3}, {169, 207, 226}};
      });
  EXPECT_EQ(asked, 1);
  const std::string info = info_of(folder, files);
  EXPECT_TRUE(contains(info, "<Name>red</Name>")) << info;
  EXPECT_TRUE(contains(info, "<F>B</F>"));
  EXPECT_TRUE(contains(info, "<F>207</F>"));
  EXPECT_FALSE(contains(info, "<F>A</F>")) << "it owns no pixel";
}

TEST(RasterFile, rainfall_has_its_classes_and_their_colours) {
  const std::vector<float> rainfall(600, 2.5F);
  const TemporaryFolder folder;
  const std::vector<RasterClass> classes{{0, 2, {1, 2, 3}}, {2.5, 7.25, {4, 5, 6}}};
  const auto files = rainfall_geotiff(output_to(folder.path("map.tif")), rows_of(rainfall, 300), {},
                                      [&] { return classes; });
  ASSERT_EQ(files.size(), 2U);
  const std::string info = info_of(folder, files);
  EXPECT_TRUE(contains(info, "tableType=\"athematic\"")) << info;
  EXPECT_TRUE(contains(info, "<F>7.25</F>"));
  EXPECT_TRUE(contains(info, "<F>6</F>"));
}

TEST(RasterFile, is_stored_as_wanted) {
  const PixelGrid large{{0, 0}, 1, 1000, 600};
  const std::vector<float> rainfall(600'000, 1);
  const auto info = [&](Compression compression, bool has_overviews) {
    const TemporaryFolder folder;
    RasterOutput output = output_to(folder.path("map.tif"), large);
    output.compression = compression;
    output.has_overviews = has_overviews;
    return info_of(folder, rainfall_geotiff(output, rows_of(rainfall, 1000), {}));
  };
  EXPECT_TRUE(contains(info(Compression::deflate, false), "COMPRESSION=DEFLATE"));
  EXPECT_TRUE(contains(info(Compression::zstd, false), "COMPRESSION=ZSTD"));
  EXPECT_FALSE(contains(info(Compression::none, false), "COMPRESSION"));
  EXPECT_FALSE(contains(info(Compression::deflate, false), "Overviews"));
  EXPECT_TRUE(contains(info(Compression::deflate, true), "Overviews: 500x300, 250x150"));
}

TEST(RasterFile, the_same_pixels_make_the_same_bytes) {
  const PixelGrid large{{0, 0}, 1, 1000, 1100};
  std::vector<std::int32_t> owners(1'100'000);
  std::vector<float> rainfall;
  for (std::size_t i = 0; i < owners.size(); ++i) {
    owners[i] = static_cast<std::int32_t>(i % 977 * (i / 1000) % 1013);
    rainfall.push_back(static_cast<float>(owners[i]));
  }
  const std::vector<std::string> ids(1013, "a");
  const auto bytes = [&](const std::string& path, unsigned threads) {
    RasterOutput output = output_to(path, large);
    output.has_overviews = true;
    output.threads = threads;
    return owners_geotiff(output, rows_of(owners, 1000), ids).at(0).bytes +
           rainfall_geotiff(output, rows_of(rainfall, 1000), {}).at(0).bytes;
  };
  const std::string one = bytes("a.tif", 1);
  EXPECT_TRUE(one == bytes("a.tif", 1));
  EXPECT_TRUE(one == bytes("b.tif", 2));
  EXPECT_TRUE(one == bytes("a.tif", 5));
}

}  // namespace
}  // namespace thiessen
