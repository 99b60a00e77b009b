#include "rainfall/methods/sphere_stolen_areas.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

Direction centre(Direction a, Direction b, Direction c) {
  return unit(cross(b - a, c - a));
}

}  // namespace

double spherical_area(Direction a, Direction b, Direction c) {
  const double volume = dot(a, cross(b - a, c - a));
  const double rest = 1 + dot(a, b) + dot(b, c) + dot(c, a);
  const double t = volume / rest;
  // For small angles the series of the arc tangent is right to 1e-17.
  constexpr double small = 0.01;
  if (rest > 0 && std::abs(t) < small)
    return 2 * t * (1 - t * t * (1. / 3 - t * t * (1. / 5 - t * t / 7)));
  return 2 * std::atan2(volume, rest);
}

void SphereStolenAreas::take(const Topology<2>& topology, const std::vector<Direction>& gauges) {
  make_room(topology);
  topology.for_each_vertex([&](VertexId v) { take(topology, gauges, v); });
}

// No vertex is formed by one point three times.
void SphereStolenAreas::make_room(const Topology<2>& topology) {
  if (known_.size() < topology.size())
    known_.resize(topology.size(), {{infinite_point, infinite_point, infinite_point}, {}});
}

void SphereStolenAreas::take(const Topology<2>& topology, const std::vector<Direction>& gauges,
                             VertexId v) {
  const auto& forming = topology.forming(v);
  Known& known = known_[index(v)];
  if (std::equal(forming.begin(), forming.end(), known.forming.begin())) return;
  std::copy(forming.begin(), forming.end(), known.forming.begin());
  known.centre =
      centre(gauges[index(forming[0])], gauges[index(forming[1])], gauges[index(forming[2])]);
}

void SphereStolenAreas::find(const Topology<2>& topology, const ConflictZone<2>& zone,
                             const std::vector<Direction>& gauges, Direction x,
                             std::vector<StolenArea>& areas) {
  make_room(topology);
  for (const VertexId v : zone.vertices()) take(topology, gauges, v);
  const auto& rim = zone.rim();
  const auto with = [&](PointId p, PointId q) {
    return centre(x, gauges[index(p)], gauges[index(q)]);
  };
  areas.clear();
  const Direction last = with(begin_of(topology, rim.back()), begin_of(topology, rim.front()));
  Direction before = last;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const PointId gauge = begin_of(topology, rim[i]);
    const Direction after = i + 1 < rim.size() ? with(gauge, begin_of(topology, rim[i + 1])) : last;
    const auto& end = i == 0 ? rim.back() : rim[i - 1];
    double area = 0;
    VertexId v = rim[i].inside;
    Direction from = known_[index(v)].centre;
    for (;;) {
      const std::size_t corner = topology.corner_of(v, gauge);
      const std::size_t across = corner == 2 ? 0 : corner + 1;
      if (v == end.inside && across == end.side) break;
      v = topology.neighbour(v, across);
      const Direction to = known_[index(v)].centre;
      area += spherical_area(after, from, to);
      from = to;
    }
    area += spherical_area(after, from, before);
    areas.push_back({gauge, std::max(0.0, area)});
    before = after;
  }
}

}  // namespace thiessen
