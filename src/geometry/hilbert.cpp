#include "geometry/hilbert.h"

namespace thiessen {

std::uint32_t hilbert_distance(const Box& box, Point p) {
  return HilbertGrid<2>(coordinates(box.low), coordinates(box.high)).distance(p);
}

}  // namespace thiessen
