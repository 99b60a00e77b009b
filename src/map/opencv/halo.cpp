#include "map/opencv/halo.h"

#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace thiessen {

Coverage halo(const Coverage& coverage, int radius) {
  Coverage grown(coverage.width + 2 * radius, coverage.height + 2 * radius);
  if (coverage.values.empty()) return grown;
  // OpenCV only reads from the coverage, but its interface asks for one that may be written to.
  const cv::Mat source(coverage.height, coverage.width, CV_8UC1,
                       const_cast<std::uint8_t*>(coverage.values.data()));
  cv::Mat room;
  cv::copyMakeBorder(source, room, radius, radius, radius, radius, cv::BORDER_CONSTANT);
  cv::Mat pixels(grown.height, grown.width, CV_8UC1, grown.values.data());
  const cv::Size side(2 * radius + 1, 2 * radius + 1);
  cv::dilate(room, pixels, cv::getStructuringElement(cv::MORPH_ELLIPSE, side));
  return grown;
}

}  // namespace thiessen
