#pragma once

#include <string>
#include <vector>

#include "outlines/antimeridian.h"
#include "outlines/winding_ring.h"

namespace thiessen {

/// How the longitudes of a polygon are written where it crosses the antimeridian.
enum class Longitudes {
  run_on,  ///< beyond it, from a least one in [-180, 180); cut there where that cannot be
  cut,     ///< all in [-180, 180]
};

/// Adds the polygon of an outer ring and its holes, all in any direction, to a shape. A ring that
/// winds round the Earth and is not known to hold a pole holds the nearer one, by its mean latitude
/// along the way; an outer ring with a hole that winds too holds the same as the hole: between them
/// is a band. Such a polygon, one that holds both poles, and one that is wider than a turn are cut
/// at the antimeridian, with edges along it and along the poles that they hold; others keep the
/// direction of their rings. Empty, or what cannot be made a polygon: a ring that winds more than
/// once, or on the whole along the equator.
std::string add_polygon(std::vector<WindingRing> rings, Longitudes longitudes, CurvedShape& into);

}  // namespace thiessen
