#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "geometry/pixel_grid.h"
#include "geometry/polygon.h"

namespace thiessen {

/// A surface's values at the centres of a raster's pixels, and where its ground ends among them.
struct PixelValues {
  PixelGrid grid;
  std::span<const float> values;  ///< row by row from the north; NaN where there is no ground
  /// Whether each centre lies within the ground; empty: all do.
  std::span<const std::uint8_t> is_within{};
  /// The same for any point, which tells where the ground ends between two centres.
  std::function<bool(Point)> holds{};
};

/// The ground whose values are at least `low` and less than `high`. Each square between four
/// centres is parted into two triangles, along the diagonal whose ends differ less, in which values
/// are linear. So bands that share a level share their edges, but for rounding. Outer rings run
/// counter-clockwise. Cost: the pixels, and n log n for n edges.
MultiPolygon ground_between(const PixelValues& surface, double low, double high);

}  // namespace thiessen
