#include <utility>

#include "io/basin_mending.h"
#include "io/winding_polygon.h"

namespace thiessen {
namespace {

bool is_closed(const Ring& ring) {
  return !ring.empty() && ring.front() == ring.back();
}

void close(Ring& ring) {
  if (!is_closed(ring)) ring.push_back(ring.front());
}

}  // namespace

std::string unwrap_longitudes(MultiPolygon& shape) {
  CurvedShape result;
  for (const Polygon& polygon : shape) {
    std::vector<WindingRing> rings = {ring_the_short_way(polygon.outer)};
    for (const Ring& hole : polygon.holes) rings.push_back(ring_the_short_way(hole));
    const std::size_t first = result.shape.size();
    std::string fault = add_polygon(std::move(rings), Longitudes::run_on, result);
    if (!fault.empty()) return fault;
    // What was cut has open rings, and whether a file's rings are closed is for mend() to see.
    const bool opened = result.shape.size() > first && is_closed(polygon.outer) &&
                        !is_closed(result.shape[first].outer);
    for (std::size_t i = first; opened && i < result.shape.size(); ++i) {
      close(result.shape[i].outer);
      for (Ring& hole : result.shape[i].holes) close(hole);
    }
  }
  shape = std::move(result.shape);
  return {};
}

}  // namespace thiessen
