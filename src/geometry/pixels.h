#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace thiessen {

/// The formats of image files in which pixels are encoded.
enum class ImageFormat { png, jpeg };

/// The pixels of a picture: blue, green, red for each, row by row from the top.
struct Pixels {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> bytes;
};

/// Encodes pixels as the bytes of an image file, or throws Error. What draws is handed one, because
/// the rooms of pictures link no library that knows the formats.
using ImageEncoder = std::vector<unsigned char> (*)(const Pixels& pixels, ImageFormat format);

}  // namespace thiessen
