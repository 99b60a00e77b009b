#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A closed line in longitude and latitude (degrees) that may run on over the antimeridian, wind
/// round the Earth, and pass a pole.
struct WindingRing {
  Ring points;                 ///< longitudes in [-180, 180]; the last joins the first
  std::vector<int> turns;      ///< by point: whole turns to add eastward where the line passes it
  std::vector<double> bulges;  ///< by edge, as Basin::bulges; empty where edges are straight
  int winding = 0;  ///< eastward turns that the line makes before it is back at its first point
  bool holds_south = false;  ///< known to go round the south pole
  bool holds_north = false;

  std::size_t size() const { return points.size(); }
  /// The position of point i with its turns added; at size() it is the first point again, after the
  /// winding.
  Point at(std::size_t i) const;
  int turn_at(std::size_t i) const { return i < size() ? turns[i] : turns[0] + winding; }
  void push_back(Point point, int turn);
};

/// The ring with its longitudes as they are: an edge spans what its coordinates say.
WindingRing ring_as_written(const Ring& ring);

/// Whether both points are at the same pole, so that the edge between them has no length.
bool at_one_pole(Point a, Point b);

/// The ring with edges that go the short way: an edge that spans more than 180 degrees goes over
/// the antimeridian. A stretch along a pole has no length, so points there that lead once round it
/// go all the way round.
WindingRing ring_the_short_way(const Ring& ring);

/// The line in the other direction, from the same first point.
WindingRing reversed(const WindingRing& ring);

/// The ring's points with their turns added, as the line runs.
Ring unwrapped(const WindingRing& ring);

/// The mean latitude of a ring that winds, weighted by the longitude that it gains along its way.
double mean_latitude(const WindingRing& ring);

/// Leads a ring that winds back along the pole (latitude -90 or 90) at which it has points, so that
/// it winds no more. False where it has no points there.
bool lead_back_along(double pole, WindingRing& ring);

/// Whether an edge of the ring runs along latitude -90 or 90.
bool runs_along_a_pole(const WindingRing& ring);

}  // namespace thiessen
