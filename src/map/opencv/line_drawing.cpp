#include "map/opencv/line_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/interrupt.h"
#include "map/opencv/fine_grid.h"

namespace thiessen {
namespace {

/// The box of a line's points.
struct Reach {
  double left = HUGE_VAL;
  double top = HUGE_VAL;
  double right = -HUGE_VAL;
  double bottom = -HUGE_VAL;

  void add(Point p) {
    left = std::min(left, p.x);
    top = std::min(top, p.y);
    right = std::max(right, p.x);
    bottom = std::max(bottom, p.y);
  }
};

Reach reach_of(Polyline line) {
  Reach reach;
  for (const Point p : line) reach.add(p);
  return reach;
}

/// The pixels of the picture that lines of this reach can touch.
cv::Rect touched(const Reach& reach, Point corner, double width, const cv::Mat& pixels) {
  const double rim = width / 2 + 1;
  const auto pixel = [](double at, int most) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, static_cast<double>(most)));
  };
  const int left = pixel(reach.left - rim - corner.x, pixels.cols);
  const int top = pixel(reach.top - rim - corner.y, pixels.rows);
  const int right = pixel(reach.right + rim + 1 - corner.x, pixels.cols);
  const int bottom = pixel(reach.bottom + rim + 1 - corner.y, pixels.rows);
  return {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
}

/// The thickness that OpenCV is asked for. It draws 1 as 1, and else the next odd number above an
/// even one: lines have an odd number of fine pixels, and a little more where they are slanted, as
/// what the outline touches is drawn. So of two odd numbers equally near the lower one is taken.
int thickness(double fine_width) {
  const int odd = 2 * static_cast<int>(std::ceil(fine_width / 2 - 1)) + 1;
  return odd <= 1 ? 1 : odd - 1;
}

}  // namespace

void draw_lines(const cv::Mat& pixels, Point corner, std::span<const Polyline> lines,
                const Stroke& stroke) {
  const int fineness = stroke.width < 4 ? 8 : 4;
  const int thick = thickness(stroke.width * fineness);
  std::vector<Reach> reaches;
  Reach all;
  for (const Polyline line : lines) {
    throw_if_interrupted();
    reaches.push_back(reach_of(line));
    if (line.empty()) continue;
    all.add({reaches.back().left, reaches.back().top});
    all.add({reaches.back().right, reaches.back().bottom});
  }
  const cv::Rect box = touched(all, corner, stroke.width, pixels);
  if (box.empty()) return;
  const int rows = fine::rows_at_once(box.width, fineness, 1);
  for (int row = box.y; row < box.y + box.height; row += rows) {
    const cv::Rect strip(box.x, row, box.width, std::min(rows, box.y + box.height - row));
    const Point upper_left{corner.x + strip.x, corner.y + strip.y};
    cv::Mat grid(strip.size() * fineness, CV_8UC1, cv::Scalar::all(0));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      throw_if_interrupted();
      if ((touched(reaches[i], corner, stroke.width, pixels) & strip).empty()) continue;
      const std::vector<cv::Point> line = fine::places(lines[i], upper_left, fineness);
      cv::polylines(grid, line, false, cv::Scalar::all(255), thick, cv::LINE_8, fine::shift);
    }
    cv::Mat coverage;
    cv::resize(grid, coverage, strip.size(), 0, 0, cv::INTER_AREA);
    fine::blend(pixels(strip), coverage, stroke.colour, stroke.alpha);
  }
}

}  // namespace thiessen
