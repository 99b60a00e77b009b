#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "tessellation/number_of.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// The points of a tessellation in the order of the numbers by which its user knows them.
template <int Dimension>
std::vector<std::pair<std::uint64_t, PointId>> points_by_number(
    const Tessellation<Dimension>& tessellation, const NumberOf& number_of) {
  std::vector<std::pair<std::uint64_t, PointId>> points;
  points.reserve(tessellation.count());
  tessellation.for_each_point([&](PointId p) { points.emplace_back(number_of(p), p); });
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace thiessen
