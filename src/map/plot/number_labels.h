#pragma once

#include <cstdint>

#include "map/ink/canvas.h"
#include "map/ink/labels.h"
#include "map/opencv/typesetter.h"

namespace thiessen {

/// Writes points' numbers beside their dots: none over another or over a dot, and where there is a
/// choice, where the fewest lines are.
class NumberLabels {
 public:
  /// `size`: of the numerals, in pixels. What is drawn afterwards but by this is not avoided.
  NumberLabels(Canvas& canvas, const PixelBox& panel, Typesetter& type, int size);

  /// No number comes over the dot from now on.
  void keep_clear(Point dot, double radius);
  /// Whether there was room. `radius`: of the dot, its rim included.
  bool write(std::uint64_t number, Point dot, double radius, Colour colour);

 private:
  std::uint64_t darkness(const PixelBox& box);

  Canvas& canvas_;
  PixelBox panel_;
  Typesetter& type_;
  int size_;
  int rim_;
  Occupancy taken_;
};

}  // namespace thiessen
