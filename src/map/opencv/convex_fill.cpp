#include "map/opencv/convex_fill.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace thiessen {

void fill_convex(std::span<const Point> polygon, std::int32_t number, const PixelWindow& window) {
  constexpr int fraction_bits = 8;
  constexpr double units = 1 << fraction_bits;
  thread_local std::vector<cv::Point> corners;
  corners.clear();
  for (const Point p : polygon) {
    corners.emplace_back(static_cast<int>(std::floor(p.x * units + 0.5)),
                         static_cast<int>(std::floor(p.y * units + 0.5)));
  }
  cv::Mat image(window.rows, window.columns, CV_32S, window.first,
                window.stride * sizeof(std::int32_t));
  cv::fillConvexPoly(image, corners.data(), static_cast<int>(corners.size()), cv::Scalar(number),
                     cv::LINE_8, fraction_bits);
}

}  // namespace thiessen
