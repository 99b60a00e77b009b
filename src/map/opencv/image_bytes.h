#pragma once

#include <span>
#include <vector>

namespace thiessen {

/// The pixels of a picture, row by row from the top, each as blue, green and red.
struct ImagePixels {
  int width;
  int height;
  std::span<const unsigned char> bytes;  ///< 3 x width x height
};

/// The bytes of an image file, by libpng or libjpeg themselves: OpenCV's module of image files is
/// linked to the libraries of all formats that it knows, which took longer to load, in every
/// command, than all else together. The files are those that it wrote, to the byte. Empty where the
/// library fails, which it does where a side is longer than the format allows. Throws
/// std::bad_alloc.
std::vector<unsigned char> png_bytes(const ImagePixels& pixels);
std::vector<unsigned char> jpeg_bytes(const ImagePixels& pixels);

}  // namespace thiessen
