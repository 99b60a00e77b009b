#include "rainfall/methods/gauge_chart.h"

#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/sphere_tessellation.h"
#include "geometry/predicates.h"

namespace thiessen {
namespace {

/// Keeps the centre that is farthest from its nearest place. Of equally far ones it keeps the first
/// by coordinates, so that the order of the places does not matter.
class Farthest {
 public:
  void consider(Direction centre, Direction place) {
    const auto key = std::tuple(dot(centre, place), centre.x, centre.y, centre.z);
    if (centre_ && key >= key_) return;
    centre_ = centre;
    key_ = key;
  }
  const std::optional<Direction>& centre() const { return centre_; }
  /// Whether it is less than a quarter of a great circle away from its nearest place.
  bool is_less_than_hemisphere() const { return std::get<0>(key_) > 0; }

 private:
  std::optional<Direction> centre_;
  std::tuple<double, double, double, double> key_;
};

Direction across(Direction a, Direction b) {
  const Direction sum = a + b;
  if (dot(sum, sum) > 0) return unit(-1.0 * sum);
  return unit(cross(a, std::abs(a.z) < 0.5 ? Direction{0, 0, 1} : Direction{1, 0, 0}));
}

/// The point from which the chart of some places is seen.
struct Viewpoint {
  Direction at;
  ChartKind kind;
};

/// The centre of the largest circle on the sphere that has no place inside, or where that is less
/// than a hemisphere the first place.
Viewpoint viewpoint_of(std::span<const Point> places) {
  const SphereTessellation sphere(places);
  const Tessellation<2>& chart = sphere.tessellation();
  Farthest farthest;
  const auto consider = [&](PlaceIndex a, PlaceIndex b, PlaceIndex c, double side) {
    const auto [first, second, third] = sphere.in_order({a, b, c});
    farthest.consider(side * sphere.centre(first, second, third), sphere.direction(first));
  };
  if (chart.span() == Span::plane) {
    chart.topology().for_each_vertex([&](VertexId v) {
      const auto& forming = chart.topology().forming(v);
      consider(sphere.place(forming[0]), sphere.place(forming[1]), sphere.place(forming[2]), 1);
    });
    if (farthest.is_less_than_hemisphere())
      return {sphere.direction(sphere.pole()), ChartKind::whole_earth};
    return {*farthest.centre(), ChartKind::part_of_earth};
  }
  // Without a triangle all places lie on one circle.
  std::vector<PlaceIndex> ring{sphere.pole()};
  for (const PointId p : chart.along_line()) ring.push_back(sphere.place(p));
  if (ring.size() == 1) return {-1.0 * sphere.direction(ring[0]), ChartKind::part_of_earth};
  if (ring.size() == 2) {
    return {across(sphere.direction(ring[0]), sphere.direction(ring[1])), ChartKind::part_of_earth};
  }
  consider(ring[0], ring[1], ring[2], 1);
  consider(ring[0], ring[1], ring[2], -1);
  return {*farthest.centre(), ChartKind::part_of_earth};
}

double in_range_or_0(double coordinate) {
  return std::abs(coordinate) < smallest_coordinate ? 0 : coordinate;
}

}  // namespace

GaugeChart::GaugeChart(std::span<const Point> places, Metric metric) {
  if (metric != Metric::geodesic) return;
  const Viewpoint viewpoint = viewpoint_of(places);
  kind_ = viewpoint.kind;
  stereographic_.emplace(viewpoint.at);
}

ChartPoint GaugeChart::at(Point position) const {
  ChartPoint point{position, {}};
  if (stereographic_) {
    point.direction = on_sphere(position);
    point.at = stereographic_->project(point.direction);
  }
  point.at = {in_range_or_0(point.at.x), in_range_or_0(point.at.y)};
  return point;
}

ChartPoint GaugeChart::found_at(Point in_chart) const {
  const Point at{in_range_or_0(in_chart.x), in_range_or_0(in_chart.y)};
  return {at, stereographic_ ? stereographic_->unproject(at) : Direction{}};
}

}  // namespace thiessen
