#include "outlines/wide_edges.h"

#include <algorithm>
#include <cmath>

#include "base/number.h"
#include "outlines/area_words.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

Point next(const Ring& ring, std::size_t i) {
  return ring[i + 1 < ring.size() ? i + 1 : 0];
}

WideEdges::Edge edge_at(const Ring& ring, std::size_t i) {
  return {ring[i], next(ring, i)};
}

/// Whether an edge runs along a parallel, but not a pole, to a point whole turns away.
bool is_full_turn(Point a, Point b) {
  return a.y == b.y && a.x != b.x && std::abs(a.y) != 90 && std::remainder(b.x - a.x, 360) == 0;
}

template <typename Visit>
void for_each_full_turn(const Ring& ring, const Visit& visit) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (is_full_turn(ring[i], next(ring, i))) visit(i);
  }
}

/// The ring with vertices at every quarter of its full turns, so that no edge is too wide.
Ring with_vertices_on_circles(const Ring& ring) {
  constexpr double quarter = 90;
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = next(ring, i);
    result.push_back(a);
    if (!is_full_turn(a, b)) continue;
    const int pieces = static_cast<int>(std::abs(b.x - a.x) / quarter);
    for (int k = 1; k < pieces; ++k) result.push_back({a.x + (b.x - a.x) * k / pieces, a.y});
  }
  return result;
}

/// Whether a ring holds some ground if its full turns are single points. Edges along a pole do not
/// count.
bool has_area_without_circles(const Ring& ring) {
  Ring path;
  double at = ring.front().x;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    path.push_back({at, ring[i].y});
    const Point to = next(ring, i);
    if (!at_one_pole(ring[i], to)) at += std::remainder(to.x - ring[i].x, 360);
  }
  const bool winds = std::round((at - ring.front().x) / 360) != 0;
  return winds || signed_area(path) != 0;
}

std::string words(const WideEdges::Edge& edge) {
  return shortest_text(edge.from.x) + " " + shortest_text(edge.from.y) + " to " +
         shortest_text(edge.to.x) + " " + shortest_text(edge.to.y);
}

std::string words(const std::vector<WideEdges::Edge>& edges) {
  std::string text = "the edge from " + words(edges.front());
  if (edges.size() > 1) text += " (and " + std::to_string(edges.size() - 1) + " more)";
  return text;
}

std::string span_of(const WideEdges::Edge& edge) {
  return "spans " + rounded_text(std::abs(edge.to.x - edge.from.x)) + " degrees of longitude";
}

/// What an edge that goes the short way passes. In longitudes from 0 to 360 that is Greenwich.
std::string passage(const WideEdges::Edge& edge) {
  const bool to_180 = std::abs(edge.from.x) <= 180 && std::abs(edge.to.x) <= 180;
  return to_180 ? ", over the antimeridian" : "";
}

}  // namespace

std::string WideEdges::fault() const {
  if (unclear.empty()) return {};
  return words(unclear) + " " + span_of(unclear.front()) + ": which way it goes is not known";
}

std::vector<std::string> WideEdges::assumptions() const {
  std::vector<std::string> texts;
  if (!short_way.empty())
    texts.push_back(words(short_way) + " " + span_of(short_way.front()) +
                    " and is taken the short way" + passage(short_way.front()));
  if (!circles.empty()) texts.push_back(words(circles) + " is taken as the whole parallel");
  if (!one_point.empty()) texts.push_back(words(one_point) + " is taken as one point, given twice");
  return texts;
}

WindingRing ring_as_meant(const Ring& ring, WideEdges& found) {
  bool turns_fully = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = next(ring, i);
    const double span = std::abs(b.x - a.x);
    if (span <= 180 || at_one_pole(a, b)) continue;
    if (is_full_turn(a, b)) {
      turns_fully = true;
    } else if (std::abs(std::remainder(span, 360)) >= 90) {
      found.unclear.push_back({a, b});
    } else {
      found.short_way.push_back({a, b});
    }
  }
  if (!turns_fully) return ring_the_short_way(ring);
  if (has_area_without_circles(ring)) {
    for_each_full_turn(ring, [&](std::size_t i) { found.one_point.push_back(edge_at(ring, i)); });
    return ring_the_short_way(ring);
  }
  for_each_full_turn(ring, [&](std::size_t i) { found.circles.push_back(edge_at(ring, i)); });
  return ring_the_short_way(with_vertices_on_circles(ring));
}

}  // namespace thiessen
