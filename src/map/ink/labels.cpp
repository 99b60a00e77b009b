#include "map/ink/labels.h"

#include <algorithm>
#include <cmath>

namespace thiessen {

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

std::array<PixelBox, 8> boxes_beside(Point dot, double radius, int gap, int width, int height) {
  const int x = static_cast<int>(std::floor(dot.x));
  const int y = static_cast<int>(std::floor(dot.y));
  const int away = static_cast<int>(std::ceil(radius)) + gap;
  const int corner = static_cast<int>(std::ceil(radius)) + 1;
  const int above = y - away - height;
  return {{{x + away, y - height / 2, width, height},
           {x - away - width, y - height / 2, width, height},
           {x - width / 2, above, width, height},
           {x - width / 2, y + away, width, height},
           {x + corner, y - corner - height, width, height},
           {x + corner, y + corner, width, height},
           {x - corner - width, y - corner - height, width, height},
           {x - corner - width, y + corner, width, height}}};
}

std::optional<PixelBox> place_beside(const Occupancy& map, Point dot, double radius, int gap,
                                     int width, int height) {
  for (const PixelBox& box : boxes_beside(dot, radius, gap, width, height)) {
    if (map.is_free(box)) return box;
  }
  return std::nullopt;
}

}  // namespace thiessen
