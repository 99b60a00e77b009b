#include "outlines/polygon_validity.h"

#include <cmath>

#include "outlines/geos.h"
#include "outlines/ring_direction.h"

namespace thiessen {

double plane_area(const MultiPolygon& shape) {
  double sum = 0;
  for (const Polygon& polygon : shape) {
    sum += std::abs(signed_area(polygon.outer));
    for (const Ring& hole : polygon.holes) sum -= std::abs(signed_area(hole));
  }
  return sum;
}

std::string validity_fault(const MultiPolygon& shape) {
  const Geos geos;
  const Geos::Shape geometry = geos.shape_of(shape);
  constexpr char valid = 1;
  if (geometry && GEOSisValid_r(geos.context(), geometry.get()) == valid) return {};
  std::string reason = geos.text().empty() ? "GEOS gives no reason" : geos.text();
  for (char& c : reason) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return reason;
}

}  // namespace thiessen
