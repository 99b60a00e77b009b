#include "earth/area/ellipsoid_surface.h"

#include "earth/area/ellipsoid_area.h"

namespace thiessen {

double EllipsoidSurface::under(Point a, Point b, double reference) const {
  return area_under(a, b, reference);
}

void EllipsoidSurface::under_each(std::span<const Segment> segments, double reference,
                                  std::vector<double>& areas) const {
  areas_under(segments, reference, areas);
}

}  // namespace thiessen
