#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "map/ink/canvas.h"

namespace thiessen {

/// Tells which pixels of the map are taken by dots and labels.
class Occupancy {
 public:
  Occupancy(int width, int height);

  /// Whether the box lies inside the map and none of its pixels is taken. Cost: the box's pixels.
  bool is_free(const PixelBox& box) const;
  void occupy(const PixelBox& box);

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> taken_;
};

/// The boxes of the given size beside a dot, in order of preference: to the right, left, above,
/// below, and at its corners. `gap` is the distance from the dot in pixels.
std::array<PixelBox, 8> boxes_beside(Point dot, double radius, int gap, int width, int height);

/// The first of boxes_beside that is free; none where all eight are taken. `gap` is the distance
/// from the dot in pixels.
std::optional<PixelBox> place_beside(const Occupancy& map, Point dot, double radius, int gap,
                                     int width, int height);

}  // namespace thiessen
