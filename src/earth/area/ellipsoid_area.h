#pragma once

#include <span>
#include <vector>

#include "geometry/point.h"
#include "geometry/segment.h"

namespace thiessen {

/// The area in square metres on the WGS 84 ellipsoid between the segment a→b, straight in longitude
/// and latitude (degrees), and the parallel `reference_latitude`: positive where the segment runs
/// eastward north of the parallel. Summed round a counter-clockwise ring it gives minus the ring's
/// area.
///
/// Laws: 1. area_under(b, a, r) == -area_under(a, b, r), bit for bit. 2. A ring's sum does not
/// depend on r.
///
/// Accuracy: 1e-15 of the product of the segment's length and its height above the parallel, and
/// for segments that rise by less than 6.4 km what the fourth term of a series would add, 1e-12 of
/// the product of length and rise where it is most. Cost:
/// 0.2 microseconds for every two degrees of latitude. Source: the authalic integral A(phi) = b^2/2
/// (s / (1 - e^2 s^2) + artanh(e s) / e), s = sin(phi), taken as differences throughout to avoid
/// cancellation.
double area_under(Point a, Point b, double reference_latitude);
/// The same for each of some segments, bit for bit.
void areas_under(std::span<const Segment> segments, double reference_latitude,
                 std::vector<double>& areas);

/// The area in square metres between a curve and its chord, which is straight in longitude and
/// latitude (degrees): positive where the curve lies to the right of the way from `start` to `end`.
/// `middle` is the curve's point halfway along it; longitudes may be a turn apart. The curve is
/// taken for a parabola and the Earth's curvature for that at its middle. Accuracy: 1e-4 of the
/// area for a curve of constant curvature and 30 km. Cost: 50 nanoseconds.
double area_beside_chord(Point start, Point middle, Point end);
/// The area in square metres of a square radian of longitude and latitude at a latitude, by its
/// sine and cosine.
double square_radian(double sine, double cosine);

}  // namespace thiessen
