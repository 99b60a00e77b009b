#include "study/far_cause.h"

#include <algorithm>
#include <utility>

namespace thiessen {
namespace {

FarCause::Correction scaled(double x, double y) {
  return [x, y](std::vector<Point> points) {
    for (Point& p : points) p = {p.x * x, p.y * y};
    return points;
  };
}

std::vector<Point> swapped(std::vector<Point> points) {
  for (Point& p : points) std::swap(p.x, p.y);
  return points;
}

}  // namespace

std::vector<FarCause> far_causes_of_coordinates(bool on_earth) {
  if (on_earth) {
    return {{"latitude and longitude swapped in one of the files", swapped, {}},
            {"the other sign of longitude (west is negative)", scaled(-1, 1), {}},
            {"the other sign of latitude (south is negative)", scaled(1, -1), {}}};
  }
  return {{"x and y swapped in one of the files", swapped, {}},
          {"the gauges' coordinates in kilometres, not metres", scaled(1000, 1000), {}},
          {"the basins' coordinates in kilometres, not metres", scaled(0.001, 0.001), {}},
          {"the other sign of x", scaled(-1, 1), {}},
          {"the other sign of y", scaled(1, -1), {}}};
}

}  // namespace thiessen
