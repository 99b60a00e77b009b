#include "map/opencv/halo.h"

#include <opencv2/imgproc.hpp>

namespace thiessen {

Coverage halo(const Coverage& coverage, int radius) {
  Coverage grown(coverage.width + 2 * radius, coverage.height + 2 * radius);
  for (int y = 0; y < coverage.height; ++y) {
    for (int x = 0; x < coverage.width; ++x) {
      grown.at(x + radius, y + radius) = coverage.at(x, y);
    }
  }
  if (coverage.values.empty()) return grown;
  cv::Mat pixels(grown.height, grown.width, CV_8UC1, grown.values.data());
  const cv::Size side(2 * radius + 1, 2 * radius + 1);
  const cv::Mat source = pixels.clone();
  cv::dilate(source, pixels, cv::getStructuringElement(cv::MORPH_ELLIPSE, side));
  return grown;
}

}  // namespace thiessen
