#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "geometry/point.h"

namespace thiessen {

/// How far along Hilbert's curve through `box` the point lies, in steps of a grid of 65536 x 65536.
/// Near numbers are near points. Requires a point of the box.
std::uint32_t hilbert_distance(const Box& box, Point p);

/// The order in which points are inserted: rounds of random choice, each twice the one before
/// (Amenta, Choi and Rote, Incremental constructions con BRIO, 2003), and along Hilbert's curve
/// within a round, so that each point is near the one before and cavities stay small whatever the
/// input's order. Returns positions in `points`; the same for the same input. Cost: n log n.
std::vector<std::uint32_t> insertion_order(std::span<const Point> points);

}  // namespace thiessen
