#include "earth/area/ellipsoid_surface.h"

#include "earth/area/ellipsoid_area.h"

namespace thiessen {

double EllipsoidSurface::under(Point a, Point b, double reference) const {
  return area_under(a, b, reference);
}

}  // namespace thiessen
