#include "outlines/common_turn.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/ring_location.h"

namespace thiessen {
namespace {

struct Reach {
  double west;  // in [-180, 180)
  double east;  // at most 360 further east
};

Reach reach_of(const Polygon& polygon) {
  const Box box = box_of(polygon.outer);
  const double west = box.low.x - 360 * std::floor((box.low.x + 180) / 360);
  return {west, west + box.width()};
}

void move_by(Polygon& polygon, double degrees) {
  if (degrees == 0) return;
  for (Point& p : polygon.outer) p.x += degrees;
  for (Ring& hole : polygon.holes) {
    for (Point& p : hole) p.x += degrees;
  }
}

/// The western end of the longitudes that begin east of the widest gap; empty where there is no
/// gap.
std::optional<double> start_of_turn(std::vector<Reach> reaches) {
  std::sort(reaches.begin(), reaches.end(),
            [](const Reach& a, const Reach& b) { return a.west < b.west; });
  double covered = -360;
  for (const Reach& reach : reaches) covered = std::max(covered, reach.east - 360);
  double widest = 0;
  std::optional<double> start;
  for (const Reach& reach : reaches) {
    if (reach.west - covered > widest) {
      widest = reach.west - covered;
      start = reach.west;
    }
    covered = std::max(covered, reach.east);
  }
  return start;
}

double eastward_from(double start, const Polygon& part) {
  const double west = box_of(part.outer).low.x;
  return -360 * std::floor((west - start) / 360);
}

}  // namespace

void bring_to_common_turn(std::span<CurvedShape* const> shapes) {
  std::vector<Reach> reaches;
  Box as_they_are;
  for (const CurvedShape* shape : shapes) {
    for (const Polygon& part : shape->shape) {
      reaches.push_back(reach_of(part));
      as_they_are.take_in(box_of(part.outer));
    }
  }
  const std::optional<double> start = start_of_turn(reaches);
  if (!start) {
    for (CurvedShape* shape : shapes) cut_at_antimeridian(*shape);
    return;
  }
  Box together;
  for (const CurvedShape* shape : shapes) {
    for (const Polygon& part : shape->shape) {
      const Box box = box_of(part.outer);
      const double move = eastward_from(*start, part);
      together.take_in(Box{{box.low.x + move, box.low.y}, {box.high.x + move, box.high.y}});
    }
  }
  constexpr double rounding = 1e-9;
  if (as_they_are.width() <= together.width() + rounding) return;
  for (CurvedShape* shape : shapes) {
    for (Polygon& part : shape->shape) move_by(part, eastward_from(*start, part));
  }
}

}  // namespace thiessen
