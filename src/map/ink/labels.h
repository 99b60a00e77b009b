#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "map/ink/canvas.h"

namespace thiessen {

/// Which pixels of the map are taken by dots and labels.
class Occupancy {
 public:
  Occupancy(int width, int height);

  /// Whether the box lies inside the map and no pixel of it is taken. Cost: the box's pixels.
  bool is_free(const PixelBox& box) const;
  void occupy(const PixelBox& box);

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> taken_;
};

/// The boxes of the given size beside a dot: to the right, left, above, below, and at its corners.
/// `gap`: pixels between the dot and the box.
std::array<PixelBox, 8> boxes_beside(Point dot, double radius, int gap, int width, int height);

/// A free box of the given size beside a dot: to the right if it can be, else left, above, below,
/// or at a corner; none where all eight are taken. `gap`: pixels between the dot and the box.
std::optional<PixelBox> place_beside(const Occupancy& map, Point dot, double radius, int gap,
                                     int width, int height);

}  // namespace thiessen
