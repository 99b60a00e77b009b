#include "gdal/output/image_file.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "base/interrupt.h"

namespace thiessen {
namespace {

/// Two rows of three pixels: blue, green, red for each.
constexpr int width = 3;
constexpr int height = 2;
constexpr std::array<std::uint8_t, 18> few{255, 0, 0,   0, 255, 0, 0, 0, 255,
                                           1,   2, 250, 9, 9,   9, 0, 0, 0};

/// The bytes of an image file as GDAL reads them: red, green, blue for each pixel.
std::vector<std::uint8_t> read_back(std::vector<unsigned char> file) {
  const char* const name = "/vsimem/image_file_test";
  VSIFCloseL(VSIFileFromMemBuffer(name, file.data(), file.size(), FALSE));
  std::vector<std::uint8_t> bytes;
  {
    const std::unique_ptr<GDALDataset> image(GDALDataset::Open(name, GDAL_OF_RASTER));
    if (image == nullptr || image->GetRasterCount() != 3) return {};
    const int across = image->GetRasterXSize();
    const int down = image->GetRasterYSize();
    bytes.resize(std::size_t{3} * static_cast<std::size_t>(across * down));
    if (image->RasterIO(GF_Read, 0, 0, across, down, bytes.data(), across, down, GDT_Byte, 3,
                        nullptr, 3, 3 * across, 1, nullptr) != CE_None)
      return {};
  }
  VSIUnlink(name);
  return bytes;
}

TEST(ImageFile, a_png_holds_the_pixels_as_they_are) {
  EXPECT_EQ(
      read_back(image_file({width, height, few}, ImageFormat::png)),
      (std::vector<std::uint8_t>{0, 0, 255, 0, 255, 0, 255, 0, 0, 250, 2, 1, 9, 9, 9, 0, 0, 0}));
}

// A JPEG of one colour differs from it by rounding alone.
TEST(ImageFile, a_jpeg_holds_them_nearly) {
  std::vector<std::uint8_t> orange;
  for (int i = 0; i < 64 * 48; ++i) orange.insert(orange.end(), {10, 120, 240});
  const auto bytes = read_back(image_file({64, 48, orange}, ImageFormat::jpeg));
  ASSERT_EQ(bytes.size(), orange.size());
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    ASSERT_LE(std::abs(bytes[i] - 240), 2);
    ASSERT_LE(std::abs(bytes[i + 1] - 120), 2);
    ASSERT_LE(std::abs(bytes[i + 2] - 10), 2);
  }
}

TEST(ImageFile, is_none_after_ctrl_c) {
  watch_for_interrupts();
  std::raise(SIGINT);
  EXPECT_THROW(image_file({width, height, few}, ImageFormat::png), Interrupted);
  forget_interrupt();
}

}  // namespace
}  // namespace thiessen
