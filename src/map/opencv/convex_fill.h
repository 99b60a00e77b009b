#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/point.h"

namespace thiessen {

/// A rectangle of the pixels of an image of whole numbers.
struct PixelWindow {
  std::int32_t* first = nullptr;  ///< the pixel in the upper left corner
  int columns = 0;
  int rows = 0;
  std::size_t stride = 0;  ///< from a pixel to the one below it

  std::int32_t* row(int r) const { return first + static_cast<std::size_t>(r) * stride; }
};

/// How far from a polygon the centre of a pixel may be that is filled with it, in columns and in
/// rows each. OpenCV draws a polygon's edges, too, and rounds where they cross rows and columns;
/// that makes half a pixel. The rest is for what corners are rounded to, 1/512, and for steps along
/// edges in 1/65536.
inline constexpr double filled_beyond = 0.5 + 1.0 / 128;

/// Gives the number to the window's pixels in a convex polygon, by OpenCV's fillConvexPoly. The
/// centre of the first pixel is at 0, 0; x counts columns and y rows. All pixels whose centres lie
/// in the polygon and farther than filled_beyond from its edges are filled, and none whose centres
/// are farther than that outside. Requires corners within 30,000 pixels of the first.
void fill_convex(std::span<const Point> polygon, std::int32_t number, const PixelWindow& window);

}  // namespace thiessen
