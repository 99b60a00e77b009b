#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A study area, whose areal rainfall is wanted.
struct Basin {
  std::string id;
  /// The basin's polygons in the study's coordinates (WGS 84 longitude and latitude in degrees, or
  /// the plane's). They must be valid: see Polygon.
  MultiPolygon shape;
  /// What the true edges add to the polygons, where the file's edges are curves in the study's
  /// coordinates (a projected file taken back to the ellipsoid). For each ring of `shape` in turn
  /// (outer, its holes, the next part ...) and for each of its edges it is the area in square
  /// metres between the true edge and the chord, positive where the true edge lies to the chord's
  /// right. Empty where edges are straight.
  std::vector<std::vector<double>> bulges;
};

/// The share of an edge's bulge that lies before `along`, from 0 to 1 along its chord, if the edge
/// bends like a parabola.
constexpr double bulge_share(double along) {
  return along * along * (3 - 2 * along);
}

}  // namespace thiessen
