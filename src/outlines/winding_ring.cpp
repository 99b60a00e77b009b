#include "outlines/winding_ring.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace thiessen {
namespace {

std::size_t next(std::size_t i, std::size_t size) {
  return i + 1 < size ? i + 1 : 0;
}

/// Whole turns of longitude that an edge adds if it goes the short way to the next point.
int short_step(Point a, Point b) {
  const double span = b.x - a.x;
  return std::abs(span) > 180 ? -static_cast<int>(std::round(span / 360)) : 0;
}

/// The edges of each stretch along a pole, in the order in which they follow each other round the
/// ring. A point that stands at a pole alone is no stretch.
std::vector<std::vector<std::size_t>> polar_stretches(const Ring& ring) {
  const std::size_t size = ring.size();
  const auto along = [&](std::size_t i) { return at_one_pole(ring[i], ring[next(i, size)]); };
  std::size_t start = 0;
  while (start < size && along(start)) ++start;
  std::vector<std::vector<std::size_t>> stretches;
  bool before = false;
  for (std::size_t k = 0; start < size && k < size; ++k) {
    const std::size_t edge = (start + k) % size;
    if (along(edge) && !before) stretches.emplace_back();
    if (along(edge)) stretches.back().push_back(edge);
    before = along(edge);
  }
  return stretches;
}

}  // namespace

bool at_one_pole(Point a, Point b) {
  return std::abs(a.y) == 90 && a.y == b.y;
}

Point WindingRing::at(std::size_t i) const {
  const Point point = points[i < size() ? i : 0];
  const int turn = turn_at(i);
  return turn == 0 ? point : Point{point.x + 360 * turn, point.y};
}

void WindingRing::push_back(Point point, int turn) {
  const double turned = std::abs(point.x) <= 180 ? 0 : std::round(point.x / 360);
  points.push_back({turned == 0 ? point.x : point.x - 360 * turned, point.y});
  turns.push_back(turn + static_cast<int>(turned));
}

WindingRing ring_as_written(const Ring& ring) {
  WindingRing result;
  for (const Point point : ring) result.push_back(point, 0);
  return result;
}

WindingRing ring_the_short_way(const Ring& ring) {
  std::vector<int> steps;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    steps.push_back(short_step(ring[i], ring[next(i, ring.size())]));
  }
  for (const auto& stretch : polar_stretches(ring)) {
    const double written = ring[next(stretch.back(), ring.size())].x - ring[stretch.front()].x;
    if (std::abs(written) != 360) continue;
    for (const std::size_t edge : stretch) steps[edge] = 0;
  }
  WindingRing result;
  int turn = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    result.push_back(ring[i], turn);
    turn += steps[i];
  }
  result.winding = turn;
  return result;
}

WindingRing reversed(const WindingRing& ring) {
  WindingRing result = ring;
  if (ring.points.empty()) return result;
  std::reverse(result.points.begin() + 1, result.points.end());
  std::reverse(result.turns.begin() + 1, result.turns.end());
  for (auto turn = result.turns.begin() + 1; turn != result.turns.end(); ++turn)
    *turn -= ring.winding;
  std::reverse(result.bulges.begin(), result.bulges.end());
  for (double& bulge : result.bulges) bulge = -bulge;
  result.winding = -ring.winding;
  return result;
}

Ring unwrapped(const WindingRing& ring) {
  Ring result;
  result.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) result.push_back(ring.at(i));
  return result;
}

double mean_latitude(const WindingRing& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring.at(i);
    const Point b = ring.at(i + 1);
    sum += (a.y + b.y) / 2 * (b.x - a.x);
  }
  return sum / (360 * ring.winding);
}

bool lead_back_along(double pole, WindingRing& ring) {
  const std::size_t size = ring.size();
  const auto at_pole = [&](std::size_t i) { return ring.points[i % size].y == pole; };
  std::size_t first = 0;
  while (first < size && !(at_pole(first) && !at_pole(first + size - 1))) ++first;
  if (first == size) return false;
  std::size_t last = first;
  while (at_pole(last + 1)) ++last;
  // The new way along the pole leads straight from where the line arrives to where it leaves,
  // whatever steps lie between.
  WindingRing result;
  result.holds_south = ring.holds_south;
  result.holds_north = ring.holds_north;
  const auto add = [&](std::size_t i, int turn, bool along_pole) {
    result.points.push_back(ring.points[i % size]);
    result.turns.push_back(turn);
    if (!ring.bulges.empty()) result.bulges.push_back(along_pole ? 0 : ring.bulges[i % size]);
  };
  const auto turn_at = [&](std::size_t i) {
    return i < size ? ring.turns[i] : ring.turns[i - size] + ring.winding;
  };
  add(first, turn_at(first), true);
  for (std::size_t i = last; i < first + size; ++i) add(i, turn_at(i) - ring.winding, false);
  ring = std::move(result);
  return true;
}

bool runs_along_a_pole(const WindingRing& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring.at(i);
    const Point b = ring.at(i + 1);
    if (at_one_pole(a, b) && a.x != b.x) return true;
  }
  return false;
}

}  // namespace thiessen
