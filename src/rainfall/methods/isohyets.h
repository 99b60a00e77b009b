#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// The levels of isohyets strictly between the least and the largest value: multiples of the
/// interval. Where that is 0 it is the rounded step (1, 2 or 5 times a power of ten) that makes
/// about eight levels. None where the values are equal. Requires finite values. Throws Error
/// where the interval makes more than `most_levels`.
std::vector<double> isohyet_levels(double least, double largest, double interval);
inline constexpr double most_levels = 10'000;

/// The least and the largest value of some ground.
struct ValueRange {
  double least;
  double largest;
};

/// The isohyetal mean of points that each stand for the same area: the areas between isohyets times
/// their mid-levels. The outermost areas reach from the least value of the ground to the first
/// level and from the last level to the largest. Requires at least one value, all in the range.
double isohyetal_mean(std::span<const double> values, const ValueRange& range, double interval);

/// The parts of a line on which something holds, such as lying among the gauges. A line is closed
/// where its last point repeats its first, and stays so where it holds all along. A part that ends
/// between two points ends at the last double at which it holds. Where it both begins and ends to
/// hold between two points, that is not seen. Cost: a look at each point, and some 50 at each end.
std::vector<std::vector<Point>> parts_where(const std::vector<Point>& line,
                                            const std::function<bool(Point)>& holds);

}  // namespace thiessen
