#pragma once

#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A closed line in longitude and latitude (degrees) that may run on over the antimeridian, wind
/// round the Earth, and pass a pole.
struct WindingRing {
  Ring points;                 ///< longitudes in [-180, 180]; the last joins the first
  std::vector<int> turns;      ///< by point: whole turns eastward of it where the line passes it
  std::vector<double> bulges;  ///< by edge, as Basin::bulges; empty where edges are straight
  int winding = 0;             ///< turns from the first point eastward to the first again
  bool holds_south = false;    ///< known to go round the south pole
  bool holds_north = false;

  std::size_t size() const { return points.size(); }
  /// Where the line passes its point i; the first again at size().
  Point at(std::size_t i) const;
  int turn_at(std::size_t i) const { return i < size() ? turns[i] : turns[0] + winding; }
  void push_back(Point point, int turn);
};

/// Longitudes as they are: edges span what their coordinates say.
WindingRing ring_as_written(const Ring& ring);

/// The short way: an edge that spans more than 180 degrees goes over the antimeridian. What runs
/// along a pole has no length: points there that lead once round it go all round.
WindingRing ring_the_short_way(const Ring& ring);

/// The same line the other way, from the same first point.
WindingRing reversed(const WindingRing& ring);

/// The ring on one turn after another, as it runs.
Ring unwrapped(const WindingRing& ring);

/// Of a ring that winds: along its way, weighted by the longitude that it gains there.
double mean_latitude(const WindingRing& ring);

/// A ring that winds and has points at the pole (latitude -90 or 90) is led back along it, so that
/// it winds no more. False where it has none.
bool lead_back_along(double pole, WindingRing& ring);

/// Whether an edge runs along latitude -90 or 90.
bool runs_along_a_pole(const WindingRing& ring);

}  // namespace thiessen
