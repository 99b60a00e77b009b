#include "cli/options/blocks/raster_options.h"

#include <string>
#include <vector>

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Raster : Given<RasterOptions> {
  Raster() { block.declare(options); }
  explicit Raster(const std::vector<std::string>& words) : Raster() { read(words); }
  /// What a picture says of them, or a NetCDF.
  std::string of_picture() const {
    return said([&] { block.check_picture(); });
  }
  std::string of_netcdf() const {
    return said([&] { block.check_netcdf(); });
  }

 private:
  template <typename Check>
  static std::string said(Check check) {
    try {
      check();
    } catch (const UsageError& error) {
      return error.text;
    }
    return {};
  }
};

TEST(RasterOptions, are_one_deflated_raster_of_a_size_that_is_chosen_later_unless_told) {
  const Raster raster(std::vector<std::string>{});
  EXPECT_EQ(raster.block.resolution, 0);
  EXPECT_EQ(raster.block.compression, Compression::deflate);
  EXPECT_FALSE(raster.block.has_overviews);
  EXPECT_FALSE(raster.block.of_steps);
}

TEST(RasterOptions, take_what_they_are_told) {
  const Raster raster({"--resolution", "0.25", "--compress", "none", "--overviews", "--steps"});
  EXPECT_EQ(raster.block.resolution, 0.25);
  EXPECT_EQ(raster.block.compression, Compression::none);
  EXPECT_TRUE(raster.block.has_overviews);
  EXPECT_TRUE(raster.block.of_steps);
  EXPECT_EQ(Raster({"--compress", "zstd"}).block.compression, Compression::zstd);
}

TEST(RasterOptions, refuse_pixels_of_no_size_and_unknown_compressions) {
  for (const std::string wrong : {"0", "-1", "nan", "inf", "1,5", ""}) {
    EXPECT_EQ(Raster().refusal({"--resolution", wrong}),
              "--resolution wants a number above 0, to 1e9, not '" + wrong + "'");
  }
  EXPECT_EQ(Raster().refusal({"--compress", "lzw"}),
            "--compress wants deflate, zstd or none, not 'lzw'");
}

TEST(RasterOptions, law_1_none_of_them_is_of_a_picture) {
  EXPECT_EQ(Raster(std::vector<std::string>{}).of_picture(), "");
  const std::vector<std::vector<std::string>> all{
      {"--resolution", "5"}, {"--compress", "deflate"}, {"--overviews"}, {"--steps"}};
  const Raster declared;
  EXPECT_EQ(declared.options.options().size(), all.size());
  for (const std::vector<std::string>& words : all)
    EXPECT_EQ(Raster(words).of_picture(), words[0] + " is of a raster, and a picture is written");
}

TEST(RasterOptions, of_a_netcdf_are_those_that_programs_read) {
  EXPECT_EQ(Raster(std::vector<std::string>{}).of_netcdf(), "a .nc is a grid of time steps");
  EXPECT_EQ(Raster({"--steps", "--resolution", "5", "--compress", "none"}).of_netcdf(), "");
  EXPECT_EQ(Raster({"--steps", "--compress", "zstd"}).of_netcdf(),
            "few programs read a NetCDF that is compressed by ZSTD");
  EXPECT_EQ(Raster({"--steps", "--overviews"}).of_netcdf(),
            "--overviews are of a .tif, and a .nc is written");
}

}  // namespace
}  // namespace thiessen::cli
