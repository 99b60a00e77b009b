#include "outlines/plane_poles.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace thiessen {
namespace {

constexpr double metres_at_pole = 1e-6;  // finer than projections are

double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

double distance_from_edge(Point a, Point b, Point p) {
  const double length = distance(a, b);
  if (length == 0) return distance(a, p);
  const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length / length;
  const double share = std::clamp(along, 0.0, 1.0);
  return distance(p, {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
}

/// The position of a pole. Some projections fail at the pole itself but not a metre beside it; then
/// the middle of two such points on opposite meridians is the pole.
std::optional<Point> pole_of(const Mapping& to_plane, double latitude) {
  if (const auto pole = to_plane({0, latitude})) return pole;
  const double beside = latitude * (1 - 1e-7);
  const auto here = to_plane({0, beside});
  const auto there = to_plane({180, beside});
  if (!here || !there) return std::nullopt;
  return Point{(here->x + there->x) / 2, (here->y + there->y) / 2};
}

}  // namespace

PlanePoles::PlanePoles(const Mapping& to_plane)
    : metres_per_unit_(to_plane.to().metres_per_unit()) {
  reach_ = metres_at_pole / metres_per_unit_;
  for (const double latitude : {-90.0, 90.0}) {
    if (const auto pole = pole_of(to_plane, latitude)) poles_.push_back({*pole, latitude});
  }
}

const PlanePoles::Pole* PlanePoles::pole_at(Point point) const {
  const auto found = std::find_if(poles_.begin(), poles_.end(), [&](const Pole& pole) {
    return distance(point, pole.at) <= reach_;
  });
  return found == poles_.end() ? nullptr : &*found;
}

bool PlanePoles::any_within(double metres, Point point) const {
  return std::any_of(poles_.begin(), poles_.end(), [&](const Pole& pole) {
    return distance(point, pole.at) * metres_per_unit_ <= metres;
  });
}

std::vector<RingNode> PlanePoles::nodes_of(const Ring& ring) const {
  std::vector<RingNode> nodes;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const Pole* at_a = pole_at(a);
    const Pole* at_b = pole_at(b);
    nodes.push_back({a, at_a == nullptr ? 0 : at_a->latitude});
    std::vector<const Pole*> passed;
    for (const Pole& pole : poles_) {
      if (&pole != at_a && &pole != at_b && distance_from_edge(a, b, pole.at) <= reach_)
        passed.push_back(&pole);
    }
    std::sort(passed.begin(), passed.end(), [&](const Pole* p, const Pole* q) {
      return distance(a, p->at) < distance(a, q->at);
    });
    for (const Pole* pole : passed) nodes.push_back({pole->at, pole->latitude});
  }
  const auto same_pole = [](const RingNode& a, const RingNode& b) {
    return a.pole != 0 && a.pole == b.pole;
  };
  nodes.erase(std::unique(nodes.begin(), nodes.end(), same_pole), nodes.end());
  while (nodes.size() > 1 && same_pole(nodes.front(), nodes.back())) nodes.pop_back();
  return nodes;
}

}  // namespace thiessen
