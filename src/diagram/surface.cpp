#include "diagram/surface.h"

namespace thiessen {

double PlaneSurface::under(Point a, Point b, double reference) const {
  return (b.x - a.x) * ((a.y - reference) + (b.y - reference)) / 2 * unit_area_;
}

}  // namespace thiessen
