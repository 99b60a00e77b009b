#pragma once

#include <string>

#include "geometry/polygon.h"

namespace thiessen {

/// Makes longitudes (degrees) run on over the antimeridian: an edge that spans more than 180
/// degrees goes the short way, except that points along a pole which lead once round it go all the
/// way round.
///
/// Each polygon is moved by whole turns so that its least longitude lies in [-180, 180), and its
/// holes with it. A polygon with a ring that winds round the Earth is closed over a pole and cut at
/// the antimeridian, as add_polygon says. Returns an empty text, or the fault of a ring.
std::string unwrap_longitudes(MultiPolygon& shape);

}  // namespace thiessen
