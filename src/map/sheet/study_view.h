#pragma once

#include <optional>
#include <vector>

#include "map/sheet/map_shape.h"
#include "map/sheet/picture.h"

namespace thiessen {

/// The study on the map's plane: how it is projected, and what of it is in sight.
struct StudyView {
  MapProjection projection = MapProjection::plane({}, 1);
  LongitudeWindow window;
  Extent extent;  ///< never empty, both sides positive
  std::vector<MapShape> cells;
  std::vector<MapShape> basins;
  std::vector<Point> gauges;
  /// How far the farthest point of the study area is from the centre: the scale there departs from
  /// the scale bar's by about the square of this, halved. In radians; 0 in a plane.
  double radius = 0;
};

/// Projects the picture's shapes. The extent holds all of them, and the gauges that own a cell as
/// far as they are not far outside. Throws Error where a coordinate is not finite or the study
/// reaches too far for double precision. Cost: the vertices.
StudyView view_study(const Picture& picture);

}  // namespace thiessen
