#include "io/edge_tracing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "earth/ellipsoid_area.h"

namespace thiessen {
namespace {

constexpr double metres_per_degree = 111320;
constexpr double least_chord_error = 1e-6;  // finer than projections are
constexpr int most_rounds = 24;
constexpr std::size_t most_chords = std::size_t{1} << 24U;

Point middle(Point a, Point b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/// The same place on the turn of the Earth on which `by` lies.
Point near(Point point, Point by) {
  const double turns = std::round((point.x - by.x) / 360);
  return {turns == 0 ? point.x : point.x - 360 * turns, point.y};
}

/// What the true edge through three quarter points cuts off, from the areas of two and of four
/// chords by Richardson's rule: the error falls with the fourth power of the chord.
double bulge(Point a, const std::array<Point, 3>& on, Point b) {
  const double latitude = on[1].y;
  const double chord = area_under(a, b, latitude);
  const double two = chord - area_under(a, on[1], latitude) - area_under(on[1], b, latitude);
  const double four = chord - area_under(a, on[0], latitude) - area_under(on[0], on[1], latitude) -
                      area_under(on[1], on[2], latitude) - area_under(on[2], b, latitude);
  return (4 * four - two) / 3;
}

}  // namespace

struct EdgeTracer::Chord {
  Point from;  ///< where it begins, in `from`
  Point from_end;
  Point to;  ///< the same in `to`
  Point to_end;
  bool settled = false;
  double bulge = 0;
};

EdgeTracer::EdgeTracer(const Crs& from, const Crs& to, double chord_error, bool bulges)
    : transformation_(from, to),
      to_(to),
      chord_error_(std::max(chord_error, least_chord_error)),
      bulges_(bulges),
      wraps_(to.geographic() && to.degrees_per_unit() == 1) {}

double EdgeTracer::metres_off(Point a, Point b, Point on) const {
  double east = to_.metres_per_unit();
  double north = east;
  if (to_.geographic()) {
    north = metres_per_degree * to_.degrees_per_unit();
    east = north * std::cos(on.y * to_.degrees_per_unit() * std::numbers::pi / 180);
  }
  const double x = (b.x - a.x) * east;
  const double y = (b.y - a.y) * north;
  const double u = (on.x - a.x) * east;
  const double v = (on.y - a.y) * north;
  const double length = std::hypot(x, y);
  return length == 0 ? std::hypot(u, v) : std::abs(x * v - y * u) / length;
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
  transformation_.apply_unproved(seen);
  std::vector<Chord> next;
  next.reserve(chords.size() + on.size() / 3);
  std::size_t at = 0;
  for (Chord& chord : chords) {
    if (chord.settled) {
      next.push_back(chord);
      continue;
    }
    std::array<Point, 3> quarters;
    double off = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      quarters[i] = wraps_ ? near(seen[at + i], chord.to) : seen[at + i];
      const double here = metres_off(chord.to, chord.to_end, quarters[i]);
      if (!std::isfinite(here)) {
        outside_ = on[at + i];
        return false;
      }
      off = std::max(off, here);
    }
    const Point half = on[at + 1];
    at += 3;
    if (off <= chord_error_) {
      chord.settled = true;
      if (bulges_) chord.bulge = bulge(chord.to, quarters, chord.to_end);
      next.push_back(chord);
    } else {
      next.push_back({chord.from, half, chord.to, quarters[1]});
      next.push_back({half, chord.from_end, quarters[1], chord.to_end});
    }
  }
  chords = std::move(next);
  return true;
}

std::optional<TracedRing> EdgeTracer::trace(const Ring& ring) {
  TracedRing traced;
  if (transformation_.identity()) {
    traced.ring = ring;
    if (bulges_) traced.bulges.assign(ring.size(), 0);
    return traced;
  }
  std::vector<Point> seen = ring;
  const std::vector<bool> inside = transformation_.apply(seen);
  const auto out = std::find(inside.begin(), inside.end(), false);
  if (out != inside.end()) {
    outside_ = ring[static_cast<std::size_t>(out - inside.begin())];
    return std::nullopt;
  }
  for (std::size_t i = 1; wraps_ && i < seen.size(); ++i) seen[i] = near(seen[i], seen[i - 1]);
  std::vector<Chord> chords;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = (i + 1) % ring.size();
    chords.push_back({ring[i], ring[j], seen[i], wraps_ ? near(seen[j], seen[i]) : seen[j]});
  }
  const auto settled = [](const Chord& chord) { return chord.settled; };
  for (int round = 0; round < most_rounds && chords.size() < most_chords; ++round) {
    if (!cut(chords)) return std::nullopt;
    if (std::all_of(chords.begin(), chords.end(), settled)) break;
  }
  const auto wild = std::find_if_not(chords.begin(), chords.end(), settled);
  if (wild != chords.end()) {
    outside_ = wild->from;
    return std::nullopt;
  }
  for (const Chord& chord : chords) {
    traced.ring.push_back(chord.to);
    if (bulges_) traced.bulges.push_back(chord.bulge);
  }
  return traced;
}

}  // namespace thiessen
