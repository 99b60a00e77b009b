#pragma once

#include "earth/cells/geodesic_bisector.h"
#include "geometry/point.h"

namespace thiessen {

/// A point of a bisector: its angle along the bisector's great circle, and where it is.
struct BisectorEnd {
  double angle;
  Point position;
};

/// The length in metres of a bisector between two of its points, `from` before `to`: that of the
/// curve of equal geodesic distances, not of the geodesic between its ends. It is the sum of
/// geodesics between points of the curve, halved until they tell no more, and what the halving has
/// won is won once more by Richardson's extrapolation.
/// Accuracy: 1e-8 of the length, and the accuracy of the bisector for each 100 km; where the two
/// places are at equal distances along several paths, near their antipodes, that of the points
/// there. Cost: three geodesics and a point of the bisector for a border of up to 100 km, and as
/// much again for each further 100 km.
double border_length(const GeodesicBisector& bisector, const BisectorEnd& from,
                     const BisectorEnd& to);

}  // namespace thiessen
