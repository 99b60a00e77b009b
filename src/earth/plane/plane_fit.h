#pragma once

#include <optional>
#include <span>

#include "earth/plane/conformal_plane.h"

namespace thiessen {

/// A plane made for a study.
struct StudyPlane {
  ConformalPlane plane;
  /// The largest share by which a length is off in the plane, anywhere on a straight line between
  /// two points of the study: the scale lies within 1 - error and 1 + error. Accuracy: a fiftieth
  /// of it.
  double scale_error;
};

/// The scale error from which on no plane is sensible: a length that may be off by a fifth says
/// nothing of what is near.
inline constexpr double largest_scale_error = 0.2;

/// Fits a plane to the points of a study, longitude and latitude in degrees. It is that of the
/// transverse Mercator, Lambert conformal and polar stereographic projections whose worst scale
/// error in the study is the least; among equals the first.
///
/// How each is fitted. A conformal scale k has no maximum inside an area, because its logarithm's
/// Laplacian is the Earth's curvature, which is positive; so the worst of it lies on the outline of
/// the study, which is its convex hull in the plane. Transverse Mercator: the central meridian for
/// which the farthest point from it is the nearest. Lambert: the standard parallel for which the
/// southern and the northern edge have one scale. Stereographic: the nearer pole. Then k_0 makes
/// the largest and the least scale equally far from 1. Longitudes and latitudes are rounded to
/// 0.001 degrees and k_0 to eight decimals, so that the plane's text is short and exact.
///
/// The first two have a cut through the Earth and only take studies within 180 degrees of
/// longitude. Requires at least one point with finite coordinates; longitudes may run on beyond
/// 180. Nothing is fitted where no projection reaches all points. The order of points does not
/// matter. Cost: linear, 10 nanoseconds a point, and a millisecond.
std::optional<StudyPlane> fit_plane(std::span<const Point> points);

}  // namespace thiessen
