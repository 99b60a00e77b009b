#pragma once

#include "geometry/polygon.h"

namespace thiessen {

/// The centroid of a basin in a plane. Rings are areas and holes whichever way they run. A shape
/// without area has the middle of its corners. Cost: linear.
Point plane_centroid(const MultiPolygon& shape);

/// The centroid of a basin on a sphere whose longitudes and latitudes are those of the shape, in
/// degrees: the direction of the sum of all its ground, seen from the sphere's middle. Edges are
/// great circles. Longitude is from -180 to 180. Accuracy: the ellipsoid's own lies within a
/// thousandth of the basin's reach. A basin whose ground has no such direction, as the whole Earth,
/// has the middle of its corners. Cost: linear.
Point sphere_centroid(const MultiPolygon& shape);

}  // namespace thiessen
