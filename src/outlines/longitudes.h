#pragma once

#include <string>

#include "geometry/polygon.h"

namespace thiessen {

/// Longitudes (degrees) made to run on over the antimeridian: an edge that spans more than 180
/// degrees goes the short way, but points along a pole that lead once round it go all round.
/// Each polygon is moved by whole turns so that its least longitude lies in [-180, 180), and its
/// holes with it; one with a ring that winds round the Earth is closed over a pole and cut at the
/// antimeridian, as add_polygon says. Empty, or what is wrong with a ring.
std::string unwrap_longitudes(MultiPolygon& shape);

}  // namespace thiessen
