#pragma once

#include <array>

#include "geometry/point.h"
#include "geometry/polygon.h"

namespace thiessen {

/// The triangle whose sides are the geodesics between three places of the Earth, in longitude and
/// latitude, in chords that lie within `tolerance` metres of them: cut at the antimeridian, and
/// with edges along a pole that it holds. Two triangles share a side vertex for vertex. The corners
/// are counter-clockwise, seen from above. The shape is empty where the chords have no inside to
/// their left, because the corners are on one geodesic to within rounding.
MultiPolygon geodesic_triangle(const std::array<Point, 3>& corners, double tolerance);

}  // namespace thiessen
