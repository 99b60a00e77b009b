#pragma once

#include <array>
#include <cstddef>

#include "geometry/point.h"

namespace thiessen {

/// Whether p < q, computed without a branch. Where ties are broken the answer is as good as random,
/// so the processor could not predict a branch.
inline bool is_lexicographically_before(const Point& p, const Point& q) {
  const auto x = static_cast<unsigned>(p.x < q.x), x_tie = static_cast<unsigned>(p.x == q.x);
  return (x | (x_tie & static_cast<unsigned>(p.y < q.y))) != 0;
}
inline bool is_lexicographically_before(const SpacePoint& p, const SpacePoint& q) {
  const auto x = static_cast<unsigned>(p.x < q.x), x_tie = static_cast<unsigned>(p.x == q.x);
  const auto y = static_cast<unsigned>(p.y < q.y), y_tie = static_cast<unsigned>(p.y == q.y);
  return (x | (x_tie & (y | (y_tie & static_cast<unsigned>(p.z < q.z))))) != 0;
}

/// The index of the point that comes last in lexicographic order. The point with the index
/// `left_out`, if there is one, does not count.
template <class P, std::size_t Count>
std::size_t lexicographically_last(const std::array<const P*, Count>& points,
                                   std::size_t left_out = Count) {
  std::size_t last = left_out == 0 ? 1 : 0;
  for (std::size_t i = last + 1; i < Count; ++i) {
    const bool later = is_lexicographically_before(*points[last], *points[i]);
    last = later && i != left_out ? i : last;
  }
  return last;
}

}  // namespace thiessen
