#include "outlines/star_shape.h"

#include <algorithm>
#include <cstddef>

#include "geometry/predicates.h"

namespace thiessen {
namespace {

Point mean_of(const Ring& ring) {
  Point sum;
  for (const Point p : ring) {
    sum.x += p.x - ring.front().x;
    sum.y += p.y - ring.front().y;
  }
  const auto count = static_cast<double>(ring.size());
  return {ring.front().x + sum.x / count, ring.front().y + sum.y / count};
}

}  // namespace

// Each edge turns to the left round the mean, by less than half a turn, so that all together turn
// by whole turns. In each of these the corners come from one side of the mean to the other twice.
bool is_star_shaped(const Ring& ring) {
  const auto is_exact = [](Point p) { return in_exact_range(p); };
  if (ring.size() < 3 || !std::all_of(ring.begin(), ring.end(), is_exact)) return false;
  const Point mean = mean_of(ring);
  if (!in_exact_range(mean)) return false;
  std::size_t changes = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i];
    const Point to = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (orientation(mean, from, to) <= 0) return false;
    if ((from < mean) != (to < mean)) ++changes;
  }
  return changes == 2;
}

}  // namespace thiessen
