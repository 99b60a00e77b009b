#include "map/opencv/picture_tags.h"

#include <gtest/gtest.h>

#include "map/opencv/encoding.h"

namespace thiessen {
namespace {

std::string text_of(const std::vector<unsigned char>& bytes) {
  return {bytes.begin(), bytes.end()};
}

TEST(PictureTags, of_a_png_are_chunks_with_their_sum) {
  PixelCanvas canvas(8, 8);
  const std::string plain = text_of(encoded(canvas, PixelFormat::png, {}));
  const std::string tagged =
      text_of(encoded(canvas, PixelFormat::png, {{"software", "a"}, {"unit", "\xC2\xB5m"}}));
  // The sum of tEXtSoftware\0a is that of zlib.crc32 in Python.
  EXPECT_EQ(tagged.substr(33, 22),
            std::string("\0\0\0\x0atEXtSoftware\0a", 18) + tagged.substr(51, 4));
  EXPECT_NE(tagged.find(std::string("iTXtunit\0\0\0\0\0\xC2\xB5m", 16)), std::string::npos);
  EXPECT_EQ(tagged.substr(0, 33), plain.substr(0, 33));
  EXPECT_TRUE(tagged.ends_with(plain.substr(33)));
}

TEST(PictureTags, of_a_jpeg_are_a_comment) {
  PixelCanvas canvas(8, 8);
  const std::string plain = text_of(encoded(canvas, PixelFormat::jpeg, {}));
  const std::string tagged =
      text_of(encoded(canvas, PixelFormat::jpeg, {{"software", "a"}, {"unit", "mm"}}));
  EXPECT_EQ(tagged, plain.substr(0, 2) + std::string("\xFF\xFE\0\x0d", 4) + "a; unit: mm" +
                        plain.substr(2));
}

}  // namespace
}  // namespace thiessen
