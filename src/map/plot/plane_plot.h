#pragma once

#include <cstddef>
#include <optional>

#include "map/opencv/pixel_canvas.h"
#include "map/plot/scene_coordinates.h"
#include "map/plot/tessellation_picture.h"

namespace thiessen {

/// Maps a plane's coordinates to the pixels of a panel.
class PlanePlot {
 public:
  /// Shows the points and a margin on equal scales, but for needles: where the range is more than
  /// `longest_shown` times as long as it is wide, the short side is stretched. Requires a point.
  explicit PlanePlot(const CoordinateRange<2>& range) : PlanePlot(range, Surroundings::margin) {}
  /// Shows this range and nothing beyond it. Requires sides longer than 0.
  static PlanePlot of_window(const PlaneWindow& window);
  /// Shows more of the plane, so that the panel has this aspect.
  void widen_to(double aspect);

  static constexpr double longest_shown = 30;

  const SceneCoordinates<2>& scene() const { return scene_; }
  /// How many times longer than at equal scales this axis is drawn; 1 where it is not stretched.
  double stretch(std::size_t axis) const { return stretch_[axis]; }
  /// The width of the panel divided by its height.
  double aspect() const { return half_[0] / half_[1]; }
  /// Half the panel's sides, in units of the scene.
  const CoordinatesIn<2>& half() const { return half_; }
  /// The pixel of the page at which a place of the scene lies.
  Point pixel(const CoordinatesIn<2>& place, const PixelBox& panel) const;

 private:
  enum class Surroundings { none, margin };
  PlanePlot(const CoordinateRange<2>& range, Surroundings surroundings);

  CoordinatesIn<2> stretch_;
  SceneCoordinates<2> scene_;
  CoordinatesIn<2> half_;
};

/// Draws the picture of a plane tessellation; see plane_picture.
PixelCanvas plot_plane(const Tessellation<2>& tessellation, const NumberOf& number_of,
                       const std::optional<PlaneWindow>& window = {}, const PlotSize& size = {});

}  // namespace thiessen
