#include "earth/sphere/nearby_positions.h"

#include <cmath>

#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/latitude_series.h"
#include "earth/sphere/small_angles.h"
#include "earth/sphere/units.h"

namespace thiessen {

NearbyPositions::NearbyPositions(Point position, Direction base)
    : position_(position),
      radius_(std::sqrt(base.x * base.x + base.y * base.y)),
      sine_(base.z),
      east_cosine_(radius_ > 0 ? base.x / radius_ : std::cos(position.x * degree)),
      east_sine_(radius_ > 0 ? base.y / radius_ : std::sin(position.x * degree)),
      latitude_gain_(latitude_series().at(sine_, radius_)) {}

Point NearbyPositions::way_to(Direction p) const {
  const double outward = p.x * east_cosine_ + p.y * east_sine_;
  const double eastward = p.y * east_cosine_ - p.x * east_sine_;
  const double radius = std::sqrt(outward * outward + eastward * eastward);
  const double rise = p.z * radius_ - sine_ * radius;  // the sine of the difference
  if (!(std::abs(eastward) <= small_angle * outward && std::abs(rise) <= small_angle))
    return far_way_to(p);
  const double gain = latitude_series().at(p.z, radius) - latitude_gain_;
  return {small_arc_tangent(eastward / outward) / degree, (small_arc_sine(rise) + gain) / degree};
}

Point NearbyPositions::far_way_to(Direction p) const {
  const Point there = from_sphere(p);
  return {std::remainder(there.x - position_.x, 360), there.y - position_.y};
}

}  // namespace thiessen
