#include "map/opencv/encoding.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/error.h"

namespace thiessen {

std::vector<unsigned char> encoded(PixelCanvas& canvas, PixelFormat format, const PictureTags& tags,
                                   int dots_to_the_inch) {
  const cv::Mat pixels(canvas.height(), canvas.width(), CV_8UC3, canvas.bytes().data());
  const bool png = format == PixelFormat::png;
  const std::vector<int> options = png ? std::vector<int>{cv::IMWRITE_PNG_COMPRESSION, 6}
                                       : std::vector<int>{cv::IMWRITE_JPEG_QUALITY, 93};
  std::vector<unsigned char> bytes;
  if (!cv::imencode(png ? ".png" : ".jpg", pixels, bytes, options) || bytes.empty()) {
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
