#include "earth/nearest/in_space.h"

#include "earth/sphere/chord_bounds.h"

namespace thiessen {

Direction in_space(Point p, Metric metric) {
  return metric == Metric::geodesic ? on_ellipsoid(p) : Direction{p.x, p.y, 0};
}

}  // namespace thiessen
