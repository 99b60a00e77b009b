#pragma once

#include <cmath>
#include <span>
#include <string>

#include "geometry/box.h"
#include "geometry/direction.h"
#include "geometry/point.h"
#include "study/study_parts.h"

namespace thiessen {

/// Measures how far apart gauges and basins of a study are: by the shortest path on the Earth where
/// the coordinates are longitude and latitude, else straight in the plane; in metres where the
/// plane's unit is known, else in that unit.
class Ruler {
 public:
  explicit Ruler(const StudyParts& parts);

  bool on_earth() const { return degrees_ > 0; }
  bool can_be_latitude(double y) const { return std::abs(y * degrees_) <= 90; }
  bool knows_metres() const { return on_earth() || metres_known_; }
  /// A point's position in space, in which what is near is near: see earth/nearest/in_space.h.
  Direction in_space(Point p) const;
  /// An upper bound on the length in space of the edge from a to b, which is straight in the
  /// coordinates. It is at most 1.02 % too long for edges that are short beside the Earth.
  double longest(Point a, Point b) const;
  double distance(Point a, Point b) const;
  /// The smallest box of some points; on the Earth its longitudes go the shorter way round and may
  /// pass 180.
  Box extent(std::span<const Point> points) const;
  /// The length of a box's diagonals, which mirror each other; half way round the Earth where the
  /// box is wider than that.
  double diagonal(const Box& box) const;
  /// The shortest distance between two boxes, 0 where they meet, to a few per cent on the Earth.
  double between(const Box& a, const Box& b) const;
  /// A distance for a message, to three digits that tell: `123 km`, `0.450 km`, or `12.0 units`.
  std::string text(double distance) const;
  /// The corners of a box for a message.
  std::string text(const Box& box) const;

 private:
  Point to_degrees(Point p) const { return {p.x * degrees_, p.y * degrees_}; }

  double degrees_ = 0;  ///< in one unit of the coordinates; 0 for lengths
  double metres_ = 1;
  bool metres_known_ = false;
};

}  // namespace thiessen
