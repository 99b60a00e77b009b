#pragma once

#include <cmath>
#include <numbers>

#include "earth/area/ellipsoid_area.h"
#include "outlines/antimeridian.h"

namespace thiessen {

/// The WGS 84 ellipsoid between two parallels, `degrees` wide, in square metres: the authalic
/// integral b^2/2 (s / (1 - e^2 s^2) + artanh(e s) / e), s = sin(latitude), in closed form.
inline double strip_area(double south, double north, double degrees) {
  const double f = 1 / 298.257223563;
  const double b = 6378137.0 * (1 - f);
  const double e = std::sqrt(f * (2 - f));
  const auto up_to = [&](double latitude) {
    const double s = std::sin(latitude * std::numbers::pi / 180);
    return b * b / 2 * (s / (1 - e * e * s * s) + std::atanh(e * s) / e);
  };
  return degrees * std::numbers::pi / 180 * (up_to(north) - up_to(south));
}

/// The area of a shape in longitude and latitude with its bulges, in square metres.
inline double area_on_earth(const CurvedShape& shape) {
  double area = 0;
  std::size_t number = 0;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      area -= area_under(ring[i], ring[(i + 1) % ring.size()], 0);
      if (!shape.bulges.empty()) area += shape.bulges.at(number).at(i);
    }
    ++number;
  };
  for (const Polygon& polygon : shape.shape) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return area;
}

}  // namespace thiessen
