#include "map/opencv/encoding.h"

#include <gtest/gtest.h>

#include <string>

#include "gdal/output/image_file.h"

namespace thiessen {
namespace {

std::string bytes_of(PixelCanvas& canvas, ImageFormat format) {
  const std::vector<unsigned char> bytes = encoded(canvas, format, image_file, {});
  return {bytes.begin(), bytes.end()};
}

/// A whole number of so many bytes, the highest first.
std::size_t number_at(const std::string& bytes, std::size_t offset, std::size_t length) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < length; ++i)
    number = number * 256 + static_cast<unsigned char>(bytes.at(offset + i));
  return number;
}

// ISO 15948: the signature, and the chunk IHDR with width, height, depth and colour type.
TEST(Encoding, a_png_has_the_canvas_s_size_in_full_colour) {
  PixelCanvas canvas(300, 40);
  const std::string bytes = bytes_of(canvas, ImageFormat::png);
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes.substr(12, 4), "IHDR");
  EXPECT_EQ(number_at(bytes, 16, 4), 300U);
  EXPECT_EQ(number_at(bytes, 20, 4), 40U);
  EXPECT_EQ(number_at(bytes, 24, 1), 8U) << "bits a channel";
  EXPECT_EQ(number_at(bytes, 25, 1), 2U) << "red, green and blue";
  EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
}

// ISO 10918-1: the frame header begins with FF C0 or FF C2, its length and depth.
TEST(Encoding, a_jpeg_has_the_canvas_s_size) {
  PixelCanvas canvas(300, 40);
  const std::string bytes = bytes_of(canvas, ImageFormat::jpeg);
  EXPECT_EQ(bytes.substr(0, 3), "\xFF\xD8\xFF");
  EXPECT_EQ(bytes.substr(bytes.size() - 2), "\xFF\xD9");
  std::size_t at = 2;
  while (number_at(bytes, at, 2) != 0xFFC0 && number_at(bytes, at, 2) != 0xFFC2)
    at += 2 + number_at(bytes, at + 2, 2);
  EXPECT_EQ(number_at(bytes, at + 5, 2), 40U);
  EXPECT_EQ(number_at(bytes, at + 7, 2), 300U);
  EXPECT_EQ(number_at(bytes, at + 9, 1), 3U) << "channels";
}

TEST(Encoding, law_1_equal_canvases_make_equal_bytes_and_one_pixel_makes_others) {
  for (const ImageFormat format : {ImageFormat::png, ImageFormat::jpeg}) {
    PixelCanvas one(64, 64);
    PixelCanvas other(64, 64);
    EXPECT_EQ(bytes_of(one, format), bytes_of(other, format));
    other.fill({63, 63, 1, 1}, {0, 0, 0});
    EXPECT_NE(bytes_of(one, format), bytes_of(other, format));
  }
  PixelCanvas red(64, 64);
  PixelCanvas blue(64, 64);
  red.fill({5, 5, 1, 1}, {255, 0, 0});
  blue.fill({5, 5, 1, 1}, {0, 0, 255});
  EXPECT_NE(bytes_of(red, ImageFormat::png), bytes_of(blue, ImageFormat::png));
}

}  // namespace
}  // namespace thiessen
