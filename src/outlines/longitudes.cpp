#include "outlines/longitudes.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "outlines/winding_polygon.h"

namespace thiessen {
namespace {

/// Removes the last point of a closed ring, which repeats the first. False where the ring is open.
bool take_off_last(Ring& ring) {
  if (ring.size() < 2 || ring.front() != ring.back()) return false;
  ring.pop_back();
  return true;
}

void close(Ring& ring) {
  if (!ring.empty()) ring.push_back(ring.front());
}

template <typename Visit>
void for_each_ring(std::span<Polygon> polygons, const Visit& visit) {
  for (Polygon& polygon : polygons) {
    visit(polygon.outer);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), visit);
  }
}

}  // namespace

std::string unwrap_longitudes(MultiPolygon& shape, WideEdges& found) {
  CurvedShape result;
  for (Polygon& polygon : shape) {
    std::vector<WindingRing> rings;
    std::vector<bool> was_closed;
    for_each_ring({&polygon, 1}, [&](Ring& ring) {
      was_closed.push_back(take_off_last(ring));
      rings.push_back(ring_as_meant(ring, found));
    });
    if (!found.unclear.empty()) return found.fault();
    const std::size_t first = result.shape.size();
    std::string fault = add_polygon(std::move(rings), Longitudes::run_on, result);
    if (!fault.empty()) return fault;
    // An open ring stays open so that mend() notices it, unless it was cut into other rings.
    const std::span<Polygon> added = std::span(result.shape).subspan(first);
    const bool same = added.size() == 1 && added[0].holes.size() == polygon.holes.size();
    std::size_t number = 0;
    for_each_ring(added, [&](Ring& ring) {
      if (!same || was_closed[number++]) close(ring);
    });
  }
  shape = std::move(result.shape);
  return {};
}

}  // namespace thiessen
