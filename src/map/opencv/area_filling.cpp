#include "map/opencv/area_filling.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/interrupt.h"
#include "map/opencv/fine_grid.h"

namespace thiessen {
namespace {

constexpr int fineness = 4;

/// A part of an area, and the heights between which it lies.
struct Part {
  const Area* area;
  std::span<const Ring> rings;
  double top = HUGE_VAL;
  double bottom = -HUGE_VAL;
};

std::vector<Part> parts_of(std::span<const Area> areas) {
  std::vector<Part> parts;
  for (const Area& area : areas) {
    for (const std::span<const Ring> rings : area.parts) {
      Part part{&area, rings};
      for (const Ring& ring : rings) {
        for (const Point p : ring) {
          part.top = std::min(part.top, p.y);
          part.bottom = std::max(part.bottom, p.y);
        }
      }
      parts.push_back(part);
    }
  }
  return parts;
}

/// Draws the stripes of a hatch, which run on from strip to strip. The grid's upper left has the
/// coordinates `corner`.
cv::Mat stripes(const cv::Size& size, Point corner, const Hatch& hatch) {
  cv::Mat drawn(size, CV_8UC1, cv::Scalar::all(0));
  const double width = static_cast<double>(size.width) / fineness;
  const double height = static_cast<double>(size.height) / fineness;
  const double first = std::floor((corner.x + corner.y) / hatch.spacing) * hatch.spacing;
  // The fill takes in the outline, half a fine pixel on either side.
  const double across = hatch.width - 1.0 / fineness;
  for (double x = first; x < corner.x + corner.y + width + height; x += hatch.spacing) {
    const double above = x - corner.y;
    const double below = above - height;
    const double bottom = corner.y + height;
    const std::vector<cv::Point> corners{fine::place({above, corner.y}, corner, fineness),
                                         fine::place({above + across, corner.y}, corner, fineness),
                                         fine::place({below + across, bottom}, corner, fineness),
                                         fine::place({below, bottom}, corner, fineness)};
    cv::fillConvexPoly(drawn, corners, cv::Scalar::all(255), cv::LINE_8, fine::shift);
  }
  return drawn;
}

void fill_strip(cv::Mat strip, Point corner, const std::vector<Part>& parts, bool any_hatched,
                const Hatch& hatch) {
  cv::Mat grid;
  cv::resize(strip, grid, {}, fineness, fineness, cv::INTER_NEAREST);
  cv::Mat hatched;
  if (any_hatched) hatched = cv::Mat(grid.size(), CV_8UC1, cv::Scalar::all(0));
  for (const Part& part : parts) {
    if (part.bottom < corner.y - 1 || part.top > corner.y + strip.rows + 1) continue;
    throw_if_interrupted();
    std::vector<std::vector<cv::Point>> rings;
    for (const Ring& ring : part.rings) {
      if (!ring.empty()) rings.push_back(fine::places(ring, corner, fineness));
    }
    cv::fillPoly(grid, rings, fine::scalar(part.area->colour), cv::LINE_8, fine::shift);
    if (!any_hatched) continue;
    cv::fillPoly(hatched, rings, cv::Scalar::all(part.area->hatched ? 255 : 0), cv::LINE_8,
                 fine::shift);
  }
  if (any_hatched && cv::countNonZero(hatched) > 0) {
    cv::bitwise_and(hatched, stripes(grid.size(), corner, hatch), hatched);
    grid.setTo(fine::scalar(hatch.colour), hatched);
  }
  cv::resize(grid, strip, strip.size(), 0, 0, cv::INTER_AREA);
}

}  // namespace

void fill_areas(const cv::Mat& pixels, Point corner, std::span<const Area> areas,
                const Hatch& hatch) {
  const std::vector<Part> parts = parts_of(areas);
  const bool any_hatched =
      std::any_of(areas.begin(), areas.end(), [](const Area& area) { return area.hatched; });
  const int rows = fine::rows_at_once(pixels.cols, fineness, 4);
  for (int row = 0; row < pixels.rows; row += rows) {
    fill_strip(pixels.rowRange(row, std::min(row + rows, pixels.rows)), {corner.x, corner.y + row},
               parts, any_hatched, hatch);
  }
}

}  // namespace thiessen
