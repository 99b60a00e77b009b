#include "map/opencv/fine_grid.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace thiessen::fine {

cv::Point place(Point p, Point origin, int fineness) {
  constexpr double farthest = 1 << 30;
  const auto coordinate = [&](double at, double from) {
    const double fine = ((at - from) * fineness - 0.5) * (1 << shift);
    return static_cast<int>(std::lround(std::clamp(fine, -farthest, farthest)));
  };
  return {coordinate(p.x, origin.x), coordinate(p.y, origin.y)};
}

std::vector<cv::Point> places(std::span<const Point> points, Point origin, int fineness) {
  constexpr double shortest = 1.0 / 3;
  std::vector<cv::Point> result;
  Point last{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    const bool is_end = i == 0 || i + 1 == points.size();
    if (!is_end && std::hypot(p.x - last.x, p.y - last.y) < shortest) continue;
    result.push_back(place(p, origin, fineness));
    last = p;
  }
  return result;
}

int rows_at_once(int width, int fineness, int bytes_per_pixel) {
  constexpr long long most_bytes = 8'000'000;
  const long long row = static_cast<long long>(width) * fineness * fineness * bytes_per_pixel;
  return static_cast<int>(std::max(1LL, most_bytes / std::max(1LL, row)));
}

cv::Rect rectangle(const PixelBox& box) {
  return {box.x, box.y, std::max(box.width, 0), std::max(box.height, 0)};
}

cv::Scalar scalar(Colour colour) {
  return {static_cast<double>(colour.blue), static_cast<double>(colour.green),
          static_cast<double>(colour.red)};
}

void blend(cv::Mat pixels, const cv::Mat& coverage, Colour colour, int alpha) {
  if (cv::countNonZero(coverage) == 0) return;
  constexpr double whole = 255;
  cv::Mat weight;
  coverage.convertTo(weight, CV_8U, alpha / whole);
  cv::cvtColor(weight, weight, cv::COLOR_GRAY2BGR);
  cv::Mat over(pixels.size(), CV_8UC3, scalar(colour));
  cv::multiply(over, weight, over, 1 / whole);
  cv::bitwise_not(weight, weight);
  cv::multiply(pixels, weight, pixels, 1 / whole);
  cv::add(pixels, over, pixels);
}

}  // namespace thiessen::fine
