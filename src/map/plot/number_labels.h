#pragma once

#include <cstdint>

#include "map/ink/canvas.h"
#include "map/ink/labels.h"
#include "map/opencv/pixel_canvas.h"
#include "map/opencv/typesetter.h"

namespace thiessen {

/// Writes the numbers of points beside their dots. No number covers another or a dot, and where
/// several places are free the one with the fewest lines is taken.
class NumberLabels {
 public:
  /// `size` is that of the numerals, in pixels. Numbers avoid only what is drawn already and what
  /// this class writes itself.
  NumberLabels(PixelCanvas& canvas, const PixelBox& panel, Typesetter& type, int size);

  /// Keeps numbers from now on from covering the dot.
  void keep_clear(Point dot, double radius);
  /// Writes a number beside its dot, and returns false where there is no room. `radius` is that of
  /// the dot, its rim included.
  bool write(std::uint64_t number, Point dot, double radius, Colour colour);

 private:
  PixelCanvas& canvas_;
  PixelBox panel_;
  Typesetter& type_;
  int size_;
  int rim_;
  Occupancy taken_;
};

}  // namespace thiessen
