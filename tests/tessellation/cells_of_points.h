#pragma once

#include <cstddef>
#include <vector>

#include "geometry/seeded.h"
#include "tessellation/cell.h"
#include "tessellation/simplices.h"

namespace thiessen {

template <int Dimension>
auto cell_at(const Tessellation<Dimension>& tessellation, const PositionIn<Dimension>& position) {
  return find_cell(tessellation, tessellation.find(position).value());
}

/// Points of a unit torus, so fine that its copies are exact, and the copies round it.
template <int Dimension>
std::vector<PositionIn<Dimension>> torus(Seeded& seeded, std::size_t count) {
  const auto coordinate = [&] { return static_cast<double>(seeded.below(1u << 30)) * 0x1p-30; };
  std::vector<PositionIn<Dimension>> points;
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (Dimension == 2) {
      points.push_back({coordinate(), coordinate()});
    } else {
      points.push_back({coordinate(), coordinate(), coordinate()});
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = points[i];
    for (int copy = 0; copy < (Dimension == 2 ? 9 : 27); ++copy) {
      const double right = copy % 3 - 1;
      const double up = copy / 3 % 3 - 1;
      if (copy == (Dimension == 2 ? 4 : 13)) continue;
      if constexpr (Dimension == 2) {
        points.push_back({p.x + right, p.y + up});
      } else {
        points.push_back({p.x + right, p.y + up, p.z + copy / 9 - 1});
      }
    }
  }
  return points;
}

}  // namespace thiessen
