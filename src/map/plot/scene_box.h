#pragma once

#include "map/plot/camera.h"
#include "map/plot/depth_drawing.h"
#include "map/plot/plot_sheet.h"
#include "map/plot/scene_coordinates.h"

namespace thiessen {

/// The box in which a scene is seen: its twelve edges, and coordinates along three of them.
class SceneBox {
 public:
  /// `half` holds half the box's sides, in units of the scene.
  SceneBox(const SceneCoordinates<3>& scene, const SceneVector& half, const Camera& camera,
           const SceneVector& eye)
      : scene_(scene), half_(half), camera_(camera), eye_(eye) {}

  void add_edges(DepthDrawing& drawing, const Pen& pen) const;
  /// Writes coordinates along one edge of the outline for each axis; none for an axis that is seen
  /// end on. Requires the camera to be outside the box.
  void write_coordinates(PlotSheet& sheet) const;

 private:
  struct Edge {
    std::size_t axis;
    SceneVector from;
    SceneVector to;
  };

  /// The edge along the axis at which the coordinates of the next axis and the last one have these
  /// signs.
  Edge edge(std::size_t axis, double sign_of_next, double sign_of_last) const;
  bool is_on_outline(const Edge& edge) const;
  void write_along(PlotSheet& sheet, const Edge& edge) const;

  const SceneCoordinates<3>& scene_;
  SceneVector half_;
  const Camera& camera_;
  SceneVector eye_;
};

}  // namespace thiessen
