#pragma once

#include <array>
#include <cstddef>
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

/// Tells how near the dots of the map are to a label.
class DotIndex {
 public:
  /// How many times as far as from its own dot a label is from any other at least, so that nobody
  /// reads it as another's.
  static constexpr double times_as_far = 1.5;

  /// `reach` is how far in pixels a label is from another's dot in any case. Memory: 24 bytes a
  /// dot, and 8 for each square of that size in the map. Cost: linear in both.
  DotIndex(int width, int height, const std::vector<Point>& dots, double reach);

  /// Whether a dot other than `own` lies within `reach` of the box of a label's letters, or is not
  /// `times_as_far` from it as `own` is. Dots less than half a pixel from `own` count as it. Cost:
  /// the dots in the squares that the box touches, grown by that distance.
  bool is_beside_another(const PixelBox& box, Point own) const;

 private:
  std::size_t square(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int column_of(double x) const;
  int row_of(double y) const;

  double reach_;
  int columns_;
  int rows_;
  std::vector<std::size_t> first_;  ///< of the dots of each square, and the end
  std::vector<Point> dots_;         ///< by square
};

/// The boxes of the given size beside a dot, in order of preference: to the right, left, above,
/// below, at its corners, and between these. `gap` is the distance from the dot in pixels.
std::array<PixelBox, 16> boxes_beside(Point dot, double radius, int gap, int width, int height);

/// The first of boxes_beside that is free; none where all are taken. `gap` is the distance
/// from the dot in pixels.
std::optional<PixelBox> place_beside(const Occupancy& map, Point dot, double radius, int gap,
                                     int width, int height);

/// The first of them that is also beside no other dot. `rim` is how many pixels the box of the
/// letters is smaller than that of the label on each side.
std::optional<PixelBox> place_beside(const Occupancy& map, const DotIndex& dots, Point dot,
                                     double radius, int gap, int width, int height, int rim = 0);

}  // namespace thiessen
