#include "map/opencv/encoding.h"

namespace thiessen {

std::vector<unsigned char> encoded(PixelCanvas& canvas, ImageFormat format, ImageEncoder encoder,
                                   const PictureTags& tags, int dots_to_the_inch) {
  std::vector<unsigned char> bytes =
      encoder({canvas.width(), canvas.height(), canvas.bytes()}, format);
  const bool has_density = dots_to_the_inch > 0;
  if (format == ImageFormat::png) {
    tag_png(bytes, tags);
    if (has_density) say_png_density(bytes, dots_to_the_inch);
  } else {
    if (has_density) say_jpeg_density(bytes, dots_to_the_inch);
    tag_jpeg(bytes, tags);
  }
  return bytes;
}

}  // namespace thiessen
