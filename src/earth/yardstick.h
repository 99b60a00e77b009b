#pragma once

#include <memory>
#include <span>

#include "diagram/diagram.h"
#include "diagram/surface.h"

namespace thiessen {

/// The metric, which says what "near" means: the shortest path on the ellipsoid, or straight
/// distance in the coordinates.
enum class Metric { geodesic, planar };

/// The yardstick of a study: how it measures distances and areas.
struct Yardstick {
  Metric metric = Metric::planar;
  double unit_area = 1;  ///< planar: square metres in a square unit of the coordinates
  double tolerance =
      0.1;  ///< geodesic: how far, in metres, a cell's edge may lie from the true one

  /// The Thiessen cells of `places` near `frame`, by plane_diagram or geodesic_diagram.
  Diagram diagram(std::span<const Point> places, const Box& frame, unsigned threads) const;
  /// The Thiessen cells as exact as areas need them: geodesic vertices are right to a hundredth of
  /// the tolerance.
  Diagram diagram_for_areas(std::span<const Point> places, const Box& frame) const;
  /// The accuracy of geodesic vertices for areas, in metres.
  double accuracy_for_areas() const;
  std::unique_ptr<Surface> surface() const;
};

}  // namespace thiessen
