#include "earth/surface.h"

#include "earth/ellipsoid_area.h"

namespace thiessen {

double PlaneSurface::under(Point a, Point b, double reference) const {
  return (b.x - a.x) * ((a.y - reference) + (b.y - reference)) / 2 * unit_area_;
}

double EllipsoidSurface::under(Point a, Point b, double reference) const {
  return area_under(a, b, reference);
}

}  // namespace thiessen
