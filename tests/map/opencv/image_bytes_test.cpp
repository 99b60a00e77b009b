// Files of pixels, beside those that OpenCV's own module writes with the same
// libraries.
#include "map/opencv/image_bytes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

using Bytes = std::vector<unsigned char>;

Bytes by_opencv(Bytes& pixels, int width, int height, const char* format,
                const std::vector<int>& options) {
  Bytes bytes;
  cv::imencode(format, cv::Mat(height, width, CV_8UC3, pixels.data()), bytes, options);
  return bytes;
}

// Noise, blocks of one colour, and slow changes.
Bytes random_pixels(Seeded& seeded, int width, int height) {
  Bytes pixels(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const std::uint64_t kind = seeded.below(3);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t at = i / 3 % static_cast<std::size_t>(width);
    pixels[i] = static_cast<unsigned char>(kind == 0   ? seeded.below(256)
                                           : kind == 1 ? at / 9 * 31 + i % 3 * 40
                                                       : at + i % 3 * 50);
  }
  return pixels;
}

TEST(ImageBytes, law_1_files_are_those_of_opencv_to_the_byte) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    const int width = static_cast<int>(seeded.whole(1, 300));
    const int height = static_cast<int>(seeded.whole(1, 200));
    Bytes pixels = random_pixels(seeded, width, height);
    EXPECT_EQ(png_bytes({width, height, pixels}),
              by_opencv(pixels, width, height, ".png", {cv::IMWRITE_PNG_COMPRESSION, 6}));
    EXPECT_EQ(jpeg_bytes({width, height, pixels}),
              by_opencv(pixels, width, height, ".jpg", {cv::IMWRITE_JPEG_QUALITY, 93}));
  }
}

TEST(ImageBytes, law_2_what_a_format_cannot_hold_gives_none) {
  constexpr int widest_jpeg = 65'500;
  const Bytes pixels(3 * (widest_jpeg + 1), 128);
  EXPECT_FALSE(jpeg_bytes({widest_jpeg, 1, pixels}).empty());
  EXPECT_TRUE(jpeg_bytes({widest_jpeg + 1, 1, pixels}).empty());
}

}  // namespace
}  // namespace thiessen
