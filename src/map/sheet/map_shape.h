#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "map/sheet/projection.h"

namespace thiessen {

/// A connected part of a cell or basin on the map's plane: its outer ring and its holes.
struct MapPart {
  std::vector<Ring> rings;
  /// The edges of the rings as lines to draw. Edges along a pole are left out, and so are edges
  /// along the antimeridian where it only cuts the shape in two.
  std::vector<std::vector<Point>> lines;
};

using MapShape = std::vector<MapPart>;

/// Whether any of the shapes has an edge that is drawn.
bool has_lines(const std::vector<MapShape>& shapes);

/// A box of the map's plane that grows to hold what is added; empty at first.
struct Extent {
  double west = 1;
  double south = 1;
  double east = -1;
  double north = -1;

  bool empty() const { return west > east; }
  double width() const { return east - west; }
  double height() const { return north - south; }
  void add(Point p);
};

/// The shape on the map's plane. Edges are straight in the study's coordinates; where the
/// projection bends them they are subdivided until they depart from their curve by less than
/// `tolerance` (map units), in the same way whichever end comes first. Where the map repeats, the
/// shape is repeated as far as `window` needs. Cost: the vertices.
MapShape map_shape(const MultiPolygon& shape, const MapProjection& projection,
                   const LongitudeWindow& window, double tolerance);

}  // namespace thiessen
