#include "map/ink/labels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace thiessen {
namespace {

double distance(const PixelBox& box, Point p) {
  return std::hypot(std::max({box.x - p.x, p.x - box.right(), 0.0}),
                    std::max({box.y - p.y, p.y - box.bottom(), 0.0}));
}

}  // namespace

Occupancy::Occupancy(int width, int height)
    : width_(width),
      height_(height),
      taken_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0) {}

bool Occupancy::is_free(const PixelBox& box) const {
  if (box.x < 0 || box.y < 0 || box.right() > width_ || box.bottom() > height_) return false;
  for (int y = box.y; y < box.bottom(); ++y) {
    const auto row = taken_.begin() + static_cast<std::ptrdiff_t>(y) * width_;
    if (std::find(row + box.x, row + box.right(), 1) != row + box.right()) return false;
  }
  return true;
}

void Occupancy::occupy(const PixelBox& box) {
  const int left = std::clamp(box.x, 0, width_);
  const int right = std::clamp(box.right(), left, width_);
  for (int y = std::max(box.y, 0); y < std::min(box.bottom(), height_); ++y) {
    const auto row = taken_.begin() + static_cast<std::ptrdiff_t>(y) * width_;
    std::fill(row + left, row + right, std::uint8_t{1});
  }
}

DotIndex::DotIndex(int width, int height, const std::vector<Point>& dots, double reach)
    : reach_(std::max(1.0, reach)),
      columns_(static_cast<int>(width / reach_) + 1),
      rows_(static_cast<int>(height / reach_) + 1),
      first_(square(0, rows_) + 1, 0),
      dots_(dots.size()) {
  const auto square_of = [&](Point p) { return square(column_of(p.x), row_of(p.y)); };
  for (const Point p : dots) ++first_[square_of(p) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const Point p : dots) dots_[next[square_of(p)]++] = p;
}

int DotIndex::column_of(double x) const {
  return std::clamp(static_cast<int>(std::floor(x / reach_)), 0, columns_ - 1);
}

int DotIndex::row_of(double y) const {
  return std::clamp(static_cast<int>(std::floor(y / reach_)), 0, rows_ - 1);
}

bool DotIndex::is_beside_another(const PixelBox& box, Point own) const {
  const double least = std::max(reach_, times_as_far * distance(box, own));
  const auto is_beside = [&](Point p) {
    return distance(box, p) < least && std::hypot(p.x - own.x, p.y - own.y) >= 0.5;
  };
  const int last_row = row_of(box.bottom() + least);
  const int last_column = column_of(box.right() + least);
  for (int row = row_of(box.y - least); row <= last_row; ++row) {
    for (int column = column_of(box.x - least); column <= last_column; ++column) {
      const auto begin = dots_.begin() + static_cast<std::ptrdiff_t>(first_[square(column, row)]);
      const auto end = dots_.begin() + static_cast<std::ptrdiff_t>(first_[square(column, row) + 1]);
      if (std::any_of(begin, end, is_beside)) return true;
    }
  }
  return false;
}

std::array<PixelBox, 16> boxes_beside(Point dot, double radius, int gap, int width, int height) {
  const int x = static_cast<int>(std::floor(dot.x));
  const int y = static_cast<int>(std::floor(dot.y));
  const int away = static_cast<int>(std::ceil(radius)) + gap;
  const int corner = static_cast<int>(std::ceil(radius)) + 1;
  const int above = y - away - height;
  const int high = y - height * 3 / 4;
  const int low = y - height / 4;
  const int west = x - width * 3 / 4;
  const int east = x - width / 4;
  return {{{x + away, y - height / 2, width, height},
           {x - away - width, y - height / 2, width, height},
           {x - width / 2, above, width, height},
           {x - width / 2, y + away, width, height},
           {x + corner, y - corner - height, width, height},
           {x + corner, y + corner, width, height},
           {x - corner - width, y - corner - height, width, height},
           {x - corner - width, y + corner, width, height},
           {x + away, high, width, height},
           {x + away, low, width, height},
           {x - away - width, high, width, height},
           {x - away - width, low, width, height},
           {east, above, width, height},
           {east, y + away, width, height},
           {west, above, width, height},
           {west, y + away, width, height}}};
}

std::optional<PixelBox> place_beside(const Occupancy& map, Point dot, double radius, int gap,
                                     int width, int height) {
  for (const PixelBox& box : boxes_beside(dot, radius, gap, width, height)) {
    if (map.is_free(box)) return box;
  }
  return std::nullopt;
}

std::optional<PixelBox> place_beside(const Occupancy& map, const DotIndex& dots, Point dot,
                                     double radius, int gap, int width, int height, int rim) {
  for (const PixelBox& box : boxes_beside(dot, radius, gap, width, height)) {
    const PixelBox letters{box.x + rim, box.y + rim, width - 2 * rim, height - 2 * rim};
    if (map.is_free(box) && !dots.is_beside_another(letters, dot)) return box;
  }
  return std::nullopt;
}

}  // namespace thiessen
