#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A study area.
struct Basin {
  std::string id;
  /// In the study's coordinates (WGS 84 longitude and latitude in degrees, or the plane's), valid:
  /// see Polygon.
  MultiPolygon shape;
  /// Where the file's edges are curves in the study's coordinates (a projected file taken back to
  /// the ellipsoid): for each ring of `shape` in turn (outer, its holes, the next part ...) and
  /// each of its edges, the area in square metres between the true edge and the chord, positive
  /// where the true edge lies to the chord's right. Empty where edges are straight.
  std::vector<std::vector<double>> bulges;
};

/// The share of an edge's bulge that lies before `along` (0 to 1 along its chord): a parabola's.
constexpr double bulge_share(double along) {
  return along * along * (3 - 2 * along);
}

}  // namespace thiessen
