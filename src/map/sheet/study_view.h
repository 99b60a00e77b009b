#pragma once

#include <optional>
#include <vector>

#include "map/sheet/map_shape.h"
#include "map/sheet/picture.h"

namespace thiessen {

/// The study on the map's plane: its projection, its shapes, and the part of the plane in sight.
struct StudyView {
  MapProjection projection = MapProjection::plane({}, 1);
  LongitudeWindow window;
  Extent extent;  ///< never empty, both sides positive
  std::vector<MapShape> cells;
  std::vector<MapShape> bands;
  std::vector<MapShape> basins;
  std::vector<std::vector<std::vector<Point>>> isohyets;  ///< the lines of each level
  std::vector<Point> gauges;
  /// The distance from the centre to the farthest point of the study area, in radians; 0 in a
  /// plane. The scale at that point departs from the scale bar's by about half the square of this.
  double radius = 0;
};

/// Projects the picture's shapes. The extent holds all of them, and those gauges that own a cell
/// and lie not far outside. Throws Error where a coordinate is not finite or the study reaches too
/// far for double precision. Cost: the vertices.
StudyView view_study(const Picture& picture);

/// The same in the projection of another map of the study; the extent is the picture's own.
StudyView view_study(const Picture& picture, const StudyView& other);

}  // namespace thiessen
