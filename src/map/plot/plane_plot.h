#pragma once

#include <cstddef>

#include "map/ink/canvas.h"
#include "map/plot/scene_coordinates.h"
#include "map/plot/tessellation_picture.h"

namespace thiessen {

/// How a plane's coordinates come to a panel's pixels.
class PlanePlot {
 public:
  /// Shows the points and a margin on equal scales, but for needles: where the range is more than
  /// `longest_shown` times as long as it is wide, the short side is stretched. Requires a point.
  explicit PlanePlot(const CoordinateRange<2>& range);

  static constexpr double longest_shown = 30;

  const SceneCoordinates<2>& scene() const { return scene_; }
  /// How much longer than the other axis this one is drawn; 1 where it is not.
  double stretch(std::size_t axis) const { return stretch_[axis]; }
  /// The panel's width by its height.
  double aspect() const { return half_[0] / half_[1]; }
  /// Half the panel's sides, in units of the scene.
  const CoordinatesIn<2>& half() const { return half_; }
  /// Pixels of the page, of a place in the scene.
  Point pixel(const CoordinatesIn<2>& place, const PixelBox& panel) const;

 private:
  CoordinatesIn<2> stretch_;
  SceneCoordinates<2> scene_;
  CoordinatesIn<2> half_;
};

/// Draws what plane_picture shows.
Canvas plot_plane(const Tessellation<2>& tessellation, const NumberOf& number_of);

}  // namespace thiessen
