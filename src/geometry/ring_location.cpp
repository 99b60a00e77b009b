#include "geometry/ring_location.h"

#include "geometry/predicates.h"

namespace thiessen {

Where locate(const Ring& ring, Point p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const bool a_below = a.y < p.y;
    const bool b_below = b.y < p.y;
    if (a_below == b_below && !box_of(a, b).contains(p)) continue;
    const int side = orientation(a, b, p);
    if (side == 0 && box_of(a, b).contains(p)) return Where::boundary;
    if (a_below != b_below && (side > 0) == a_below) inside = !inside;
  }
  return inside ? Where::inside : Where::outside;
}

Box box_of(const Ring& ring) {
  Box box;
  for (const Point p : ring) box.take_in(p);
  return box;
}

}  // namespace thiessen
