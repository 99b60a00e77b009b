#include "outlines/edge_tracing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "earth/area/ellipsoid_area.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

constexpr double metres_per_degree = 111320;
constexpr double least_chord_error = 1e-6;  // finer than projections are
constexpr double step_of_projections = 1;   // metres
constexpr int most_rounds = 50;
constexpr std::size_t most_chords = std::size_t{1} << 24U;
// A chord in a plane spans at most this many degrees of longitude. A straight edge past a pole
// turns by up to 180 degrees; its bulges are right to 1e-6 with chords of 3 degrees.
constexpr double widest_in_plane = 3;
constexpr double widest_in_degrees = 90;

Point middle(Point a, Point b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/// The same place, on the turn of the Earth on which `by` lies.
Point near(Point point, Point by) {
  const double turns = std::round((point.x - by.x) / 360);
  return {turns == 0 ? point.x : point.x - 360 * turns, point.y};
}

int turns_between(Point a, Point b) {
  return std::abs(b.x - a.x) > 180 ? -static_cast<int>(std::round((b.x - a.x) / 360)) : 0;
}

/// The area between a chord and the true edge through three quarter points, from the areas of two
/// and of four chords by Richardson's rule: the error falls with the fourth power of the chord.
double bulge(Point a, const Point* on, Point b) {
  const double latitude = on[1].y;
  const double chord = area_under(a, b, latitude);
  const double two = chord - area_under(a, on[1], latitude) - area_under(on[1], b, latitude);
  const double four = chord - area_under(a, on[0], latitude) - area_under(on[0], on[1], latitude) -
                      area_under(on[1], on[2], latitude) - area_under(on[2], b, latitude);
  return (4 * four - two) / 3;
}

double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// Whether the projection may be torn apart along an edge. The points on it are equally far from
/// each other in its own CRS; a step between two of them that is much longer than the others tells
/// of a tear.
bool torn(Point a, const std::array<Point, 3>& on, Point b, double least) {
  const std::array<double, 4> steps = {distance(a, on[0]), distance(on[0], on[1]),
                                       distance(on[1], on[2]), distance(on[2], b)};
  const double all = std::accumulate(steps.begin(), steps.end(), 0.0);
  return all > least && *std::max_element(steps.begin(), steps.end()) > 0.7 * all;
}

}  // namespace

struct EdgeTracer::Node {
  RingNode in;  ///< the ring's node, in `from`
  Point seen;   ///< the same in `to`
};

struct EdgeTracer::Chord {
  Point from;  ///< where it begins, in `from`
  Point from_end;
  Point to;  ///< the same in `to`
  Point to_end;
  std::size_t edge;  ///< the edge that it is a part of
  int turned = 0;    ///< whole turns of longitude that it makes to its end
  bool settled = false;
  double bulge = 0;
};

EdgeTracer::EdgeTracer(const Mapping& mapping, PlanePoles poles, double chord_error, Course course)
    : mapping_(&mapping),
      from_(mapping.from()),
      to_(mapping.to()),
      chord_error_(std::max(chord_error, least_chord_error)),
      course_(course),
      wraps_(to_.in_degrees()),
      widest_(from_.geographic ? widest_in_degrees : widest_in_plane) {
  if (wraps_) poles_ = std::move(poles);
}

/// The lengths in metres of one unit to the east and one to the north, at a point of `to`.
Point EdgeTracer::metres_at(Point point) const {
  if (!to_.geographic) return {to_.metres_per_unit(), to_.metres_per_unit()};
  const double north = metres_per_degree * to_.degrees_per_unit();
  return {north * std::cos(point.y * to_.degrees_per_unit() * std::numbers::pi / 180), north};
}

double EdgeTracer::metres_between(Point a, Point b) const {
  const Point metres = metres_at(a);
  return std::hypot((b.x - a.x) * metres.x, (b.y - a.y) * metres.y);
}

double EdgeTracer::metres_off(Point a, Point b, Point on) const {
  const Point metres = metres_at(on);
  const double x = (b.x - a.x) * metres.x;
  const double y = (b.y - a.y) * metres.y;
  const double u = (on.x - a.x) * metres.x;
  const double v = (on.y - a.y) * metres.y;
  const double length = std::hypot(x, y);
  return length == 0 ? std::hypot(u, v) : std::abs(x * v - y * u) / length;
}

/// Whether the chord lies near enough to the true edge, which passes through three quarter points;
/// such a chord counts as settled.
bool EdgeTracer::fits(Chord& chord, const Point* seen) const {
  std::array<Point, 3> quarters = {seen[0], seen[1], seen[2]};
  Point end = chord.to_end;
  if (wraps_) {
    Point before = chord.to;
    for (Point* point : {&quarters[0], &quarters[1], &quarters[2], &end}) {
      *point = near(*point, before);
      if (std::abs(point->x - before.x) > widest_) return false;
      before = *point;
    }
    if (std::abs(end.x - chord.to.x) > widest_) return false;
  }
  if (!to_.geographic && torn(chord.to, quarters, end, chord_error_ / to_.metres_per_unit()))
    return false;
  for (const Point point : quarters) {
    if (metres_off(chord.to, end, point) > chord_error_) return false;
  }
  chord.settled = true;
  chord.turned = static_cast<int>(std::round((end.x - chord.to_end.x) / 360));
  if (course_ == Course::chords_and_bulges) chord.bulge = bulge(chord.to, quarters.data(), end);
  return true;
}

/// Tries every chord that is not settled, and halves those that lie too far off. False where a
/// point lies outside the projection's area.
bool EdgeTracer::cut(std::vector<Chord>& chords) {
  std::vector<Point> on;
  for (const Chord& chord : chords) {
    if (chord.settled) continue;
    const Point half = middle(chord.from, chord.from_end);
    on.insert(on.end(), {middle(chord.from, half), half, middle(half, chord.from_end)});
  }
  std::vector<Point> seen = on;
  mapping_->apply_unproved(seen);
  std::vector<Chord> next;
  next.reserve(chords.size() + on.size() / 3);
  std::size_t at = 0;
  for (Chord& chord : chords) {
    if (chord.settled) {
      next.push_back(chord);
      continue;
    }
    for (std::size_t i = at; i < at + 3; ++i) {
      if (std::isfinite(seen[i].x) && std::isfinite(seen[i].y)) continue;
      outside_ = on[i];
      return false;
    }
    if (fits(chord, &seen[at])) {
      next.push_back(chord);
    } else {
      next.push_back({chord.from, on[at + 1], chord.to, seen[at + 1], chord.edge});
      next.push_back({on[at + 1], chord.from_end, seen[at + 1], chord.to_end, chord.edge});
    }
    at += 3;
  }
  chords = std::move(next);
  return true;
}

/// Cuts the chords until all are settled. Chords shorter than a metre that are left unsettled stay
/// as they are, because within a metre of a pole a projection may be a step function.
bool EdgeTracer::settle(std::vector<Chord>& chords) {
  const auto settled = [](const Chord& chord) { return chord.settled; };
  for (int round = 0; round < most_rounds && chords.size() < most_chords; ++round) {
    if (!cut(chords)) return false;
    if (std::all_of(chords.begin(), chords.end(), settled)) return true;
  }
  const auto wild = std::find_if(chords.begin(), chords.end(), [&](const Chord& chord) {
    const Point end = wraps_ ? near(chord.to_end, chord.to) : chord.to_end;
    return !chord.settled && !(metres_between(chord.to, end) <= step_of_projections);
  });
  if (wild == chords.end()) return true;
  outside_ = wild->from;
  return false;
}

/// Whether a point of `from` lies so near a pole that the inverse mapping proves nothing.
bool EdgeTracer::is_beside_pole(Point point) const {
  if (!from_.geographic) return poles_.any_within(step_of_projections, point);
  const double degrees = 90 - std::abs(point.y * from_.degrees_per_unit());
  return degrees * metres_per_degree <= step_of_projections;
}

/// Finds the positions of the nodes in `to`. False where one lies outside the projection's area.
bool EdgeTracer::see(std::vector<Node>& nodes) {
  std::vector<Point> seen;
  for (const Node& node : nodes) {
    if (node.in.pole == 0) seen.push_back(node.in.at);
  }
  const std::vector<bool> inside = mapping_->apply(seen);
  std::size_t next = 0;
  for (Node& node : nodes) {
    if (node.in.pole != 0) continue;
    if (!inside[next] && is_beside_pole(node.in.at)) {
      std::vector<Point> unproved = {node.in.at};
      mapping_->apply_unproved(unproved);
      seen[next] = unproved[0];
    } else if (!inside[next]) {
      outside_ = node.in.at;
      return false;
    }
    node.seen = seen[next++];
  }
  return true;
}

/// The chords of the closed line through the nodes. At a pole each chord has the longitude on which
/// it reaches the pole.
std::optional<std::vector<EdgeTracer::Chord>> EdgeTracer::chords_between(
    const std::vector<Node>& nodes) {
  const auto seen_from = [&](const Node& node, const Node& other) {
    if (node.in.pole == 0) return node.seen;
    const Point at = node.in.at;
    const Point to = other.in.at;
    const double share = std::min(1 / from_.metres_per_unit() / distance(at, to), 0.5);
    std::vector<Point> beside = {{at.x + share * (to.x - at.x), at.y + share * (to.y - at.y)}};
    mapping_->apply_unproved(beside);
    return Point{beside[0].x, node.in.pole};
  };
  std::vector<Chord> chords;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& a = nodes[i];
    const Node& b = nodes[i + 1 < nodes.size() ? i + 1 : 0];
    chords.push_back({a.in.at, b.in.at, seen_from(a, b), seen_from(b, a), i});
  }
  if (!settle(chords)) return std::nullopt;
  return chords;
}

std::optional<WindingRing> EdgeTracer::trace(const Ring& ring) {
  if (mapping_->identity()) {
    WindingRing same = wraps_ ? ring_as_written(ring) : WindingRing{ring, {}, {}};
    same.turns.resize(ring.size(), 0);
    if (course_ == Course::chords_and_bulges) same.bulges.assign(ring.size(), 0);
    return same;
  }
  std::vector<Node> nodes;
  for (const RingNode& node : poles_.nodes_of(ring)) nodes.push_back({node, {}});
  if (!see(nodes)) return std::nullopt;
  const auto chords = chords_between(nodes);
  if (!chords) return std::nullopt;
  WindingRing traced;
  int turn = 0;
  const auto add = [&](Point point, int turns_on, double bulge) {
    if (wraps_) {
      traced.push_back(point, turn);
    } else {
      traced.points.push_back(point);
      traced.turns.push_back(0);
    }
    if (course_ == Course::chords_and_bulges) traced.bulges.push_back(bulge);
    turn += turns_on;
  };
  for (std::size_t i = 0; i < chords->size(); ++i) {
    const Chord& chord = (*chords)[i];
    const Chord& next = (*chords)[i + 1 < chords->size() ? i + 1 : 0];
    const bool within = i > 0 && chord.edge == (*chords)[i - 1].edge;
    if (within && course_ == Course::ends) {
      turn += chord.turned;
    } else {
      add(chord.to, chord.turned, chord.bulge);
    }
    if (wraps_ && chord.to_end != next.to)
      add(chord.to_end, turns_between(chord.to_end, next.to), 0);
  }
  traced.winding = turn;
  find_poles_within(ring, nodes, traced);
  return traced;
}

void EdgeTracer::find_poles_within(const Ring& ring, const std::vector<Node>& nodes,
                                   WindingRing& traced) const {
  for (const PlanePoles::Pole& pole : poles_.all()) {
    const auto at_pole = [&](const Node& node) { return node.in.pole == pole.latitude; };
    if (std::any_of(nodes.begin(), nodes.end(), at_pole)) continue;
    if (locate(ring, pole.at) == Where::inside)
      (pole.latitude > 0 ? traced.holds_north : traced.holds_south) = true;
  }
}

std::optional<std::vector<DirectedEdge>> EdgeTracer::trace(const std::vector<DirectedEdge>& edges) {
  std::vector<Node> nodes;
  for (const DirectedEdge& edge : edges) {
    for (const Point point : {edge.from, edge.to}) {
      const double longitude = point.x == -180 ? 180 : point.x;
      nodes.push_back({{{std::abs(point.y) == 90 ? 0 : longitude, point.y}, 0}, {}});
    }
  }
  if (!see(nodes)) return std::nullopt;
  std::vector<Chord> chords;
  for (std::size_t i = 0; i < edges.size(); ++i)
    chords.push_back({edges[i].from, edges[i].to, nodes[2 * i].seen, nodes[2 * i + 1].seen, i});
  if (!settle(chords)) return std::nullopt;
  std::vector<DirectedEdge> traced;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const bool within = i > 0 && chords[i].edge == chords[i - 1].edge;
    if (within && course_ == Course::ends) {
      traced.back().to = chords[i].to_end;
    } else {
      traced.push_back({chords[i].to, chords[i].to_end});
    }
  }
  return traced;
}

}  // namespace thiessen
