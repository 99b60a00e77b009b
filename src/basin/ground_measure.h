#pragma once

#include <cstddef>
#include <span>

#include "geometry/point.h"

namespace thiessen {

/// Figures of ground other than its area, such as integrals of a field over it, that add up along
/// the edges that bound the ground, as areas do on a Surface. Safe for several threads at once.
class GroundMeasure {
 public:
  virtual ~GroundMeasure() = default;
  /// How many figures there are.
  virtual std::size_t figures() const = 0;
  /// Adds what an edge bears to each figure of the ground to its left. `bulge` is the area between
  /// the true edge and its chord: see Basin::bulges.
  /// Law: an edge back bears what the edge there does, with the other sign.
  virtual void add(Point from, Point to, double bulge, std::span<double> figures) const = 0;
};

}  // namespace thiessen
