#pragma once

#include <span>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// A dash of a line, given by the lengths along the line at which it begins and ends.
struct Dash {
  double from = 0;
  double to = 0;
};

/// Parts a line into dashes, at least two, with one at either end. Dashes and gaps are stretched
/// alike, as little as that allows. A line shorter than a gap is one dash.
std::vector<Dash> dashes(double length, double dash, double gap);

/// The dashes of the line through `points`, each a line of its own.
std::vector<std::vector<Point>> dashed(std::span<const Point> points, double dash, double gap);

}  // namespace thiessen
