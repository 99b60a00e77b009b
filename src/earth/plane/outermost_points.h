#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// Some thousand points at most that stand for all of a study where its outline matters.
struct OutermostPoints {
  std::vector<Point> points;  ///< longitudes run on from `west`
  double west = 0;            ///< degrees
  double width = 0;           ///< degrees of longitude; 360 where no gap is a degree wide
  double south = 0;
  double north = 0;
};

/// Finds the outermost points of a study, longitude and latitude in degrees. The longitudes begin
/// east of the widest gap. They are cut into 512 strips from north to south, and the latitudes into
/// as many from west to east; each strip keeps its two ends. Points at a pole have no longitude and
/// take the middle one. Nothing where there is no point. Cost: linear.
std::optional<OutermostPoints> outermost_points(std::span<const Point> points);

}  // namespace thiessen
