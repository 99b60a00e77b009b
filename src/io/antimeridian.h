#pragma once

#include "geometry/polygon.h"

namespace thiessen {

/// A shape in longitudes that run on over the antimeridian (170 to 190) cut there, with every
/// longitude in [-180, 180] (RFC 7946, section 3.1.9). A shape within that range stays as it is,
/// bit for bit. Two shapes that share an edge over the antimeridian are cut at one point.
MultiPolygon cut_at_antimeridian(const MultiPolygon& shape);

}  // namespace thiessen
