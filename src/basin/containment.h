#pragma once

#include <span>
#include <vector>

#include "basin/basin.h"

namespace thiessen {

/// Whether the point lies in the basin or on its edge. Exact. Cost: the basin's vertices.
bool contains(const Basin& basin, Point p);

/// How many of the points each basin contains; with `period` above 0, x repeats after it.
/// Cost: n log n, and for each point the vertices of the basins whose boxes hold it.
std::vector<std::size_t> count_within(const std::vector<Basin>& basins,
                                      std::span<const Point> points, double period);

}  // namespace thiessen
