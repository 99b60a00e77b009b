#pragma once

#include <memory>
#include <span>

#include "diagram/diagram.h"
#include "diagram/surface.h"

namespace thiessen {

/// What "near" means: the shortest path on the ellipsoid, or straight distance in the coordinates.
enum class Metric { geodesic, planar };

/// What a study measures with: how near, and how large.
struct Yardstick {
  Metric metric = Metric::planar;
  double unit_area = 1;  ///< planar: square metres in a square unit of the coordinates
  double tolerance =
      0.1;  ///< geodesic: how far, in metres, a cell's edge may lie from the true one

  /// The cells of `places` near `frame`: see plane_diagram and geodesic_diagram.
  Diagram diagram(std::span<const Point> places, const Box& frame, unsigned threads) const;
  /// The same as exact as areas need: geodesic vertices to a hundredth of the tolerance.
  Diagram diagram_for_areas(std::span<const Point> places, const Box& frame) const;
  /// Of geodesic vertices, for areas: metres.
  double accuracy_for_areas() const;
  std::unique_ptr<Surface> surface() const;
};

}  // namespace thiessen
