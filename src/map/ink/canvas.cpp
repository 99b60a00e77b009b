#include "map/ink/canvas.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

std::size_t area(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

std::uint8_t mix(std::uint8_t under, std::uint8_t over, int alpha) {
  return static_cast<std::uint8_t>((under * (255 - alpha) + over * alpha + 127) / 255);
}

}  // namespace

Coverage::Coverage(int w, int h) : width(w), height(h), values(area(w, h)) {}

Canvas::Canvas(int width, int height)
    : width_(width), height_(height), bytes_(3 * area(width, height), 255) {}

std::uint8_t* Canvas::pixel(int x, int y) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return nullptr;
  return &bytes_[3 * (area(width_, y) + static_cast<std::size_t>(x))];
}

void Canvas::set(int x, int y, Colour colour) {
  blend(x, y, colour, 255);
}

void Canvas::blend(int x, int y, Colour colour, int alpha) {
  std::uint8_t* const p = pixel(x, y);
  if (p == nullptr || alpha == 0) return;
  p[0] = mix(p[0], colour.blue, alpha);
  p[1] = mix(p[1], colour.green, alpha);
  p[2] = mix(p[2], colour.red, alpha);
}

void Canvas::blend(int x, int y, const Coverage& coverage, Colour colour, int alpha) {
  for (int row = 0; row < coverage.height; ++row) {
    for (int column = 0; column < coverage.width; ++column) {
      const int value = coverage.at(column, row);
      if (value != 0) blend(x + column, y + row, colour, (value * alpha + 127) / 255);
    }
  }
}

void Canvas::fill(const PixelBox& box, Colour colour) {
  for (int y = box.y; y < box.bottom(); ++y) {
    for (int x = box.x; x < box.right(); ++x) set(x, y, colour);
  }
}

void Canvas::border(const PixelBox& box, Colour colour, int thickness) {
  fill({box.x, box.y, box.width, thickness}, colour);
  fill({box.x, box.bottom() - thickness, box.width, thickness}, colour);
  fill({box.x, box.y, thickness, box.height}, colour);
  fill({box.right() - thickness, box.y, thickness, box.height}, colour);
}

void Canvas::disc(Point centre, double radius, Colour colour, const PixelBox& clip) {
  const int reach = static_cast<int>(std::ceil(radius)) + 1;
  const int column = static_cast<int>(std::floor(centre.x));
  const int row = static_cast<int>(std::floor(centre.y));
  for (int y = std::max(row - reach, clip.y); y <= std::min(row + reach, clip.bottom() - 1); ++y) {
    for (int x = std::max(column - reach, clip.x); x <= std::min(column + reach, clip.right() - 1);
         ++x) {
      const double distance = std::hypot(x + 0.5 - centre.x, y + 0.5 - centre.y);
      const double share = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
      blend(x, y, colour, static_cast<int>(std::lround(255 * share)));
    }
  }
}

}  // namespace thiessen
