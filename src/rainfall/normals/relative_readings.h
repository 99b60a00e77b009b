#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// Readings divided by their gauges' normals, relative to that of the first, in a month or the
/// year: what a surface between gauges is made of before it counts times the normal at each point.
/// Without normals they are the readings themselves.
inline std::vector<double> relative_readings(const NormalField* normals,
                                             std::span<const double> readings,
                                             const NormalMonth& month) {
  std::vector<double> relative(readings.begin(), readings.end());
  if (normals == nullptr) return relative;
  for (std::uint32_t s = 0; s < relative.size(); ++s)
    relative[s] /= relative_at_gauge(*normals, StationIndex{s}, month);
  return relative;
}

}  // namespace thiessen
