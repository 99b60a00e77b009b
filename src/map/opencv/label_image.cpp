#include "map/opencv/label_image.h"

#include <opencv2/imgproc.hpp>

#include "base/interrupt.h"
#include "map/opencv/fine_grid.h"

namespace thiessen {

LabelImage::LabelImage(int width, int height)
    : width_(width),
      height_(height),
      labels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), nobody) {}

void LabelImage::fill(std::span<const Ring> rings, std::int32_t label) {
  throw_if_interrupted();
  std::vector<std::vector<cv::Point>> shapes;
  for (const Ring& ring : rings) {
    if (!ring.empty()) shapes.push_back(fine::places(ring, {0, 0}, 1));
  }
  cv::Mat pixels(height_, width_, CV_32SC1, labels_.data());
  cv::fillPoly(pixels, shapes, cv::Scalar::all(label), cv::LINE_8, fine::shift);
}

}  // namespace thiessen
