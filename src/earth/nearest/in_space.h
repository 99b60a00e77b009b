#pragma once

#include "earth/yardstick.h"
#include "geometry/direction.h"

namespace thiessen {

/// The position in space of a point of the study: in the plane at height 0, on the Earth on the
/// ellipsoid, in metres from its centre. Distances between such positions are straight, through the
/// Earth: 0.03 % less than geodesics over 500 km. Unlike geodesics, they suit every variogram that
/// is valid in space.
Direction in_space(Point p, Metric metric);

}  // namespace thiessen
