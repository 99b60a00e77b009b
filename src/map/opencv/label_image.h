#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// Tells which shape each pixel of a panel shows: the last one filled that touches it. It is what
/// colours, names and labels are chosen by; how shapes are drawn does not depend on it.
class LabelImage {
 public:
  static constexpr std::int32_t nobody = -1;

  LabelImage(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  std::int32_t at(int column, int row) const {
    return labels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(column)];
  }
  /// The label of each pixel, row by row from the top.
  std::span<const std::int32_t> labels() const { return labels_; }
  std::span<std::int32_t> labels() { return labels_; }

  /// Gives `label` the pixels that the rings touch or hold, by the even-odd rule. The rings are in
  /// pixels; a pixel has its centre at .5. Coordinates must be finite. Accuracy: OpenCV takes the
  /// heights of vertices in whole pixels, so that one whose centre is up to half a pixel within the
  /// outline may be left out, and one up to two outside may be taken.
  void fill(std::span<const Ring> rings, std::int32_t label);

 private:
  int width_;
  int height_;
  std::vector<std::int32_t> labels_;
};

}  // namespace thiessen
