#pragma once

#include <string>
#include <vector>

#include "outlines/antimeridian.h"
#include "outlines/winding_ring.h"

namespace thiessen {

/// How the longitudes of a polygon are written where it crosses the antimeridian.
enum class Longitudes {
  run_on,  ///< run on beyond it from a least one in [-180, 180), or cut there where they cannot
  cut,     ///< all in [-180, 180]
};

/// Adds the polygon of an outer ring and its holes, all in any direction, to a shape. Returns an
/// empty text, or the fault that keeps the rings from being a polygon: a ring that winds more than
/// once, or that winds on the whole along the equator.
///
/// A ring that winds round the Earth and is not known to hold a pole is taken to hold the nearer
/// one, by its mean latitude along the way. An outer ring with a hole that winds too holds the same
/// pole as the hole: between them lies a band. Such a polygon, one that holds both poles, and one
/// that is wider than a turn are cut at the antimeridian, with edges along it and along the poles
/// that they hold. Other polygons keep the direction of their rings.
std::string add_polygon(std::vector<WindingRing> rings, Longitudes longitudes, CurvedShape& into);

}  // namespace thiessen
