#include "map/opencv/picture_tags.h"

#include <gtest/gtest.h>

#include "gdal/output/image_file.h"
#include "map/opencv/encoding.h"

namespace thiessen {
namespace {

std::string text_of(const std::vector<unsigned char>& bytes) {
  return {bytes.begin(), bytes.end()};
}

TEST(PictureTags, of_a_png_are_chunks_with_their_sum) {
  PixelCanvas canvas(8, 8);
  const std::string plain = text_of(encoded(canvas, ImageFormat::png, image_file, {}));
  const std::string tagged = text_of(
      encoded(canvas, ImageFormat::png, image_file, {{"software", "a"}, {"unit", "\xC2\xB5m"}}));
  // The sum of tEXtSoftware\0a is that of zlib.crc32 in Python.
  EXPECT_EQ(tagged.substr(33, 22),
            std::string("\0\0\0\x0atEXtSoftware\0a", 18) + tagged.substr(51, 4));
  EXPECT_NE(tagged.find(std::string("iTXtunit\0\0\0\0\0\xC2\xB5m", 16)), std::string::npos);
  EXPECT_EQ(tagged.substr(0, 33), plain.substr(0, 33));
  EXPECT_TRUE(tagged.ends_with(plain.substr(33)));
}

TEST(PictureTags, of_a_jpeg_are_a_comment) {
  PixelCanvas canvas(8, 8);
  const std::string plain = text_of(encoded(canvas, ImageFormat::jpeg, image_file, {}));
  const std::string tagged =
      text_of(encoded(canvas, ImageFormat::jpeg, image_file, {{"software", "a"}, {"unit", "mm"}}));
  // Behind the mark SOI and the header of JFIF, 2 and 18 bytes.
  EXPECT_EQ(tagged, plain.substr(0, 20) + std::string("\xFF\xFE\0\x0d", 4) + "a; unit: mm" +
                        plain.substr(20));
}

// ISO 15948, 11.3.5.3: pixels to the unit along x and y, and 1 for the metre; before IDAT. 300 dots
// to the inch are 11811.02 to the metre.
TEST(PictureTags, a_png_says_its_density_before_its_pixels) {
  PixelCanvas canvas(8, 8);
  const auto file = encoded(canvas, ImageFormat::png, image_file, {{"metric", "planar"}}, 300);
  const std::string bytes(file.begin(), file.end());
  const std::size_t at = bytes.find("pHYs");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(bytes.substr(at - 4, 4), std::string("\0\0\0\x09", 4));
  EXPECT_EQ(bytes.substr(at + 4, 9), std::string("\0\0\x2E\x23\0\0\x2E\x23\x01", 9));
  EXPECT_LT(at, bytes.find("IDAT"));
}

// JFIF 1.02: after the name and the version, the unit (1: inch) and the densities.
TEST(PictureTags, a_jpeg_says_its_density_in_its_header) {
  PixelCanvas canvas(8, 8);
  const auto file = encoded(canvas, ImageFormat::jpeg, image_file, {{"metric", "planar"}}, 300);
  const std::string bytes(file.begin(), file.end());
  const std::size_t at = bytes.find(std::string("JFIF\0", 5));
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(bytes.substr(at + 7, 5), std::string("\x01\x01\x2C\x01\x2C", 5));
}

TEST(PictureTags, no_density_is_said_where_none_is_given) {
  PixelCanvas canvas(8, 8);
  const auto file = encoded(canvas, ImageFormat::png, image_file, {});
  EXPECT_EQ(std::string(file.begin(), file.end()).find("pHYs"), std::string::npos);
  std::vector<unsigned char> other{1, 2, 3};
  say_jpeg_density(other, 300);
  EXPECT_EQ(other, (std::vector<unsigned char>{1, 2, 3}));
}

}  // namespace
}  // namespace thiessen
