#include "map/opencv/encoding.h"

#include "base/error.h"
#include "map/opencv/image_bytes.h"

namespace thiessen {

std::vector<unsigned char> encoded(PixelCanvas& canvas, PixelFormat format, const PictureTags& tags,
                                   int dots_to_the_inch) {
  const ImagePixels pixels{canvas.width(), canvas.height(), canvas.bytes()};
  const bool png = format == PixelFormat::png;
  std::vector<unsigned char> bytes = png ? png_bytes(pixels) : jpeg_bytes(pixels);
  if (bytes.empty()) {
    throw Error(Message{{}, 0, "the picture could not be encoded", {}});
  }
  const bool has_density = dots_to_the_inch > 0;
  if (png) {
    tag_png(bytes, tags);
    if (has_density) say_png_density(bytes, dots_to_the_inch);
  } else {
    if (has_density) say_jpeg_density(bytes, dots_to_the_inch);
    tag_jpeg(bytes, tags);
  }
  return bytes;
}

}  // namespace thiessen
