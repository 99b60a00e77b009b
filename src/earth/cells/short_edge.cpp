#include "earth/cells/short_edge.h"

#include <algorithm>
#include <cmath>

#include "earth/sphere/geodesic.h"
#include "earth/sphere/nearby_positions.h"
#include "earth/sphere/small_angles.h"
#include "earth/sphere/sphere_scale.h"
#include "earth/sphere/units.h"

// How far a short edge may be off.
//
// The offset o of the bisector from the great circle of its places, at an angle t along it, is
// where paths over a scale k are equally long: with h half the angle between the places and g the
// growth of ln k to the second place's side, o(t) = g(t) (h^2 + t^2) / 2 to the first order in g,
// which is at most 0.0034 in a radian, as is g's own growth by 0.0068, and by 0.0136 the growth of
// that. So the third derivative of o is at most 3 g' + 3 t g'' + (h^2 + t^2) g''' / 2 < 0.0207 for
// t and h below 0.005. A parabola through both ends and the middle of a stretch of length s is off
// by no more than its 1/6, times s^3 / 20.78: for s of 1e-3 that is 1.7e-13 radians, or 1.1e-6
// metres. For longer edges, up to 2e-3, there is one sample more, and the fourth derivative, at
// most 6 g'' + 4 t g''' + ... < 0.09, leaves 0.09 / 24 of the product of the distances from the
// four samples, at most 0.05 s^4: 3e-15 radians. Terms of the second order in g are 0.0034 of all
// this. Newton's method leaves a tenth of the accuracy.
//
// The fourth-degree polynomial in between is off by the fifth derivative of longitude or latitude,
// 1/120, and the product of the distances from five points, at most 0.0036 s^5. On a great circle
// the fifth derivative of the longitude is largest where that lies along a parallel: no more than
// 24 / cos^5 of the latitude and 20000 at 75 degrees, which makes 2e-14 radians, 0.26 of that on
// the ground: 4e-8 metres.

namespace thiessen {
namespace {

constexpr double longest_parabola = 1e-3;
constexpr double shortest = 1e-8;
constexpr double farthest = 0.005;        // from the places, along the edge
constexpr double farthest_across = 1e-6;  // from their great circle; the bisector's own is 1e-7
constexpr double least_growth = 0.05;

/// The great circle of two places near each other, and how far off it their bisector lies.
class NearBisector {
 public:
  // The chord has its ends' rounding, which counts where they are near each other: what is across
  // the circle is what is square to its plane.
  NearBisector(const EdgeSide& first, const EdgeSide& second, Direction chord, double accuracy)
      : first_(first),
        second_(second),
        accuracy_(accuracy),
        middle_(unit(first.direction + second.direction)),
        left_(unit(cross(middle_, chord))),
        forward_(cross(left_, middle_)) {}

  Direction forward() const { return forward_; }
  Direction at(double angle) const {
    return small_cosine(angle) * middle_ + small_sine(angle) * left_;
  }
  /// The tangent of the angle along the circle, which is small.
  double tangent_of(Direction p) const { return dot(p, left_) / dot(p, middle_); }

  /// The offset of the bisector beside a point of the circle, by Newton's method.
  std::optional<double> offset_at(Direction on_circle, double offset) const {
    constexpr int most_steps = 4;
    for (int i = 0; i < most_steps; ++i) {
      const Direction here = on_circle + offset * forward_;
      const double scale = scale_.at(here.z);
      const Path from_first = path(first_, here, scale);
      const Path from_second = path(second_, here, scale);
      const double growth = from_first.growth - from_second.growth;
      if (!(growth > least_growth)) return {};
      const double step = (from_second.metres - from_first.metres) / (growth * scale);
      offset += step;
      if (!(std::abs(offset) <= farthest_across)) return {};
      // The error that is left is of the second order in the step.
      const double metres = step * scale;
      if (metres * metres <= accuracy_ / 10 * growth * from_first.metres) return offset;
    }
    return {};
  }

 private:
  struct Path {
    double metres;
    double growth;  ///< of the length, for a step across the circle
  };
  Path path(const EdgeSide& from, Direction to, double scale) const {
    const Direction way = to - from.direction;
    const double chord = length(way);
    return {short_path(scale_, {from.direction, from.scale}, {to, scale}, chord / 2),
            dot(way, forward_) / chord};
  }

  const SphereScale& scale_ = sphere_scale();
  const EdgeSide& first_;
  const EdgeSide& second_;
  double accuracy_;
  Direction middle_;
  Direction left_;
  Direction forward_;
};

/// Offsets along a piece of a bisector, by the share of its length.
struct Offsets {
  double start;
  double end;
  double bend;       // of the middle, from the straight line between the ends
  double twist = 0;  // the factor of the third degree

  double at(double share) const {
    return start + share * (end - start) + share * (1 - share) * (4 * bend + twist * (share - 0.5));
  }
};

std::optional<Offsets> offsets_of(const NearBisector& bisector, double from, double length,
                                  double start, double end) {
  Offsets offsets{start, end, 0};
  const double straight = (start + end) / 2;
  const auto middle = bisector.offset_at(bisector.at(from + length / 2), straight);
  if (!middle) return {};
  offsets.bend = *middle - straight;
  if (length <= longest_parabola) return offsets;
  constexpr double share = 0.15;
  const double guess = offsets.at(share);
  const auto more = bisector.offset_at(bisector.at(from + share * length), guess);
  if (!more) return {};
  offsets.twist = (*more - guess) / (share * (1 - share) * (share - 0.5));
  return offsets;
}

double square_distance(Direction a, Direction b) {
  return dot(a - b, a - b);
}

}  // namespace

ShortEdge::Quartic::Quartic(double first, const std::array<double, 4>& more)
    : first_(first), differences_(more) {
  for (std::size_t order = 1; order <= differences_.size(); ++order) {
    for (std::size_t i = differences_.size() - 1; i > 0 && i + 1 >= order; --i)
      differences_[i] = (differences_[i] - differences_[i - 1]) / static_cast<double>(order);
  }
}

std::optional<ShortEdge> ShortEdge::fit(const EdgeSide& first, const EdgeSide& second,
                                        Direction chord, const EdgeEnd& start, const EdgeEnd& end,
                                        double accuracy) {
  const double square = std::max(square_distance(start.direction, first.direction),
                                 square_distance(end.direction, first.direction));
  if (!(square <= farthest * farthest) || !is_short_path(std::sqrt(square) / 2, accuracy))
    return {};
  const NearBisector bisector(first, second, chord, accuracy);
  const double from = small_arc_tangent(bisector.tangent_of(start.direction));
  const double to = small_arc_tangent(bisector.tangent_of(end.direction));
  ShortEdge edge;
  edge.length_ = to - from;
  if (!(edge.length_ >= shortest && edge.length_ <= longest)) return {};
  const Direction forward = bisector.forward();
  const auto offsets = offsets_of(bisector, from, edge.length_, dot(start.direction, forward),
                                  dot(end.direction, forward));
  if (!offsets) return {};
  const NearbyPositions near(start.position, start.direction);
  std::array<double, 4> east{};
  std::array<double, 4> north{};
  for (std::size_t quarter = 1; quarter < 4; ++quarter) {
    const double share = static_cast<double>(quarter) / 4;
    const Point way =
        near.way_to(bisector.at(from + share * edge.length_) + offsets->at(share) * forward);
    east[quarter - 1] = way.x;
    north[quarter - 1] = way.y;
  }
  east[3] = end.position.x - start.position.x;
  north[3] = end.position.y - start.position.y;
  edge.x_ = Quartic(start.position.x, east);
  edge.y_ = Quartic(start.position.y, north);
  edge.middle_latitude_ = start.position.y + north[1];
  edge.middle_ = {std::sin(edge.middle_latitude_ * degree),
                  std::cos(edge.middle_latitude_ * degree)};
  return edge;
}

ShortEdge::Latitude ShortEdge::latitude(double degrees) const {
  const double way = (degrees - middle_latitude_) * degree;
  const double square = way * way / 2;
  const double odd = way * (1 - square / 3);
  return {middle_.sine * (1 - square) + middle_.cosine * odd,
          middle_.cosine * (1 - square) - middle_.sine * odd};
}

}  // namespace thiessen
