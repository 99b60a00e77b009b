#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "earth/sphere/conformal_sphere.h"
#include "oracles/half_planes.h"

namespace thiessen {

/// What is left of a cell in the plane that touches the sphere at a point.
class TangentCell {
 public:
  explicit TangentCell(Direction middle) : middle_(middle), axes_(axes_at(middle)) {}

  /// Cuts off all that is nearer to `other` than to `own`.
  void keep_nearer(Direction own, Direction other) {
    const Direction apart = other - own;
    const long double height = dot(apart, middle_);
    const long double east = dot(apart, axes_.east);
    const long double north = dot(apart, axes_.north);
    ring_ = half_planes::kept_part(
        ring_, [&](half_planes::LongPoint p) { return height + p.x * east + p.y * north; });
  }
  /// Whether it ends within the part of the plane that is looked at.
  bool is_whole() const {
    return std::all_of(ring_.begin(), ring_.end(), [](half_planes::LongPoint p) {
      return std::max(std::abs(p.x), std::abs(p.y)) < 8;
    });
  }
  /// In triangles, whose corners are (x, y, 1) as seen from the sphere's middle.
  double area_on_sphere() const {
    long double area = 0;
    for (std::size_t i = 2; i < ring_.size(); ++i)
      area += solid_angle(ring_[0], ring_[i - 1], ring_[i]);
    return static_cast<double>(area);
  }

 private:
  static long double solid_angle(half_planes::LongPoint a, half_planes::LongPoint b,
                                 half_planes::LongPoint c) {
    const auto dot = [](half_planes::LongPoint p, half_planes::LongPoint q) {
      return p.x * q.x + p.y * q.y + 1;
    };
    const auto length = [&](half_planes::LongPoint p) { return std::sqrt(dot(p, p)); };
    return 2 * std::atan2(half_planes::doubled_area(a, b, c),
                          length(a) * length(b) * length(c) + dot(a, b) * length(c) +
                              dot(b, c) * length(a) + dot(c, a) * length(b));
  }

  Direction middle_;
  Axes axes_;
  std::vector<half_planes::LongPoint> ring_{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
};

}  // namespace thiessen
