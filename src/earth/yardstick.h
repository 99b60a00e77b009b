#pragma once

#include <memory>
#include <span>

#include "diagram/diagram.h"
#include "diagram/dual.h"
#include "diagram/surface.h"

namespace thiessen {

/// The metric, which says what "near" means: the shortest path on the ellipsoid, or straight
/// distance in the coordinates.
enum class Metric { geodesic, planar };

/// The yardstick of a study: how it measures distances and areas, and how finely it draws.
///
/// What is measured does not depend on how finely edges are drawn. Areas are those of cells whose
/// edges are chords within `measuring_tolerance` of the true ones, each with the area between edge
/// and chord; what is left of the chords is of the second order in that distance: where another
/// edge crosses a chord, less than a square of its side.
struct Yardstick {
  /// How far, in metres, the chords that areas are measured with may lie from the true edges; the
  /// usual tolerance of what is drawn, so that the same chords serve both.
  static constexpr double measuring_tolerance = 0.1;

  Metric metric = Metric::planar;
  double unit_area = 1;  ///< planar: square metres in a square unit of the coordinates
  /// geodesic: how far, in metres, a cell's edge may be drawn from the true one
  double tolerance = measuring_tolerance;

  /// The Thiessen cells of `places` near `frame` for their areas, by plane_diagram or
  /// geodesic_diagram.
  Diagram diagram(std::span<const Point> places, const Box& frame, unsigned threads,
                  Neighbours neighbours = Neighbours::wanted) const;
  /// The Thiessen cells of `places` near `frame` with edges as they are drawn, no farther than the
  /// tolerance from the true ones.
  Diagram drawn_diagram(std::span<const Point> places, const Box& frame, unsigned threads,
                        Neighbours neighbours = Neighbours::wanted) const;
  /// Whether cells are drawn with the edges that they are measured with.
  bool draws_as_measured() const {
    return metric == Metric::planar || tolerance == measuring_tolerance;
  }
  /// What the same cells say of the places, none of them cut off: see plane_dual and geodesic_dual.
  Dual dual(std::span<const Point> places, unsigned threads) const;
  /// The Thiessen cells as exact as the areas of handovers need them.
  Diagram diagram_of_heirs(std::span<const Point> places, const Box& frame) const;
  /// The accuracy of geodesic vertices between heirs, in metres.
  static constexpr double accuracy_of_heirs = 1e-2 * measuring_tolerance;
  std::unique_ptr<Surface> surface() const;
};

}  // namespace thiessen
