#include "basin/overlay.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/interrupt.h"
#include "basin/crossing.h"
#include "geometry/predicates.h"

namespace thiessen {
namespace {

void change(std::vector<std::pair<PlaceIndex, int>>& presence, PlaceIndex place, int step) {
  for (std::size_t i = 0; i < presence.size(); ++i) {
    if (presence[i].first != place) continue;
    presence[i].second += step;
    if (presence[i].second == 0) presence.erase(presence.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
  presence.emplace_back(place, step);
}

/// How far rounding may move a crossing along an edge or a chord, whose length counts as 1.
constexpr double rounding = 1e-9;

double distance(Point a, Point b) {
  const Point way{b.x - a.x, b.y - a.y};
  return std::sqrt(way.x * way.x + way.y * way.y);  // no overflow in the exact range
}

// Whether a point lies in a ring by the even-odd rule. The basin is shifted as in Crossing, so a
// point on its edge is either in or out.
bool is_within(const Ring& ring, Point p) {
  bool within = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    if ((a.y < p.y) == (b.y < p.y)) continue;
    const Point low = a.y < b.y ? a : b;
    const Point high = a.y < b.y ? b : a;
    const int side = orientation(low, high, p);
    if (side >= 0) within = !within;
  }
  return within;
}

bool is_within(const Basin& basin, Point p) {
  bool within = false;
  for (const Polygon& part : basin.shape) {
    within = within != is_within(part.outer, p);
    for (const Ring& hole : part.holes) within = within != is_within(hole, p);
  }
  return within;
}

}  // namespace

Overlay::Overlay(const Diagram& diagram, Searches searches)
    : diagram_(diagram), chord_index_(diagram, searches), stamp_(diagram.chords.size(), 0) {
  first_chord_at_.assign(diagram.nodes.size() + 1, 0);
  for (const Chord& chord : diagram.chords) {
    ++first_chord_at_[chord.from + 1];
    ++first_chord_at_[chord.to + 1];
  }
  for (std::size_t i = 1; i < first_chord_at_.size(); ++i)
    first_chord_at_[i] += first_chord_at_[i - 1];
  chord_at_.resize(2 * diagram.chords.size());
  std::vector<std::uint32_t> next(first_chord_at_.begin(), first_chord_at_.end() - 1);
  for (std::uint32_t i = 0; i < diagram.chords.size(); ++i) {
    chord_at_[next[diagram.chords[i].from]++] = i;
    chord_at_[next[diagram.chords[i].to]++] = i;
  }
}

CutBasin& Overlay::cut(const Basin& basin) {
  result_.pieces.clear();
  result_.whole_chords.clear();
  result_.touching = false;
  chord_events_.clear();
  crossed_ = false;
  nodes_within_.clear();
  ++basin_number_;

  std::size_t ring_number = 0;
  const auto cut_next = [&](const Ring& ring) {
    cut_ring(ring, basin.bulges.empty() ? nullptr : &basin.bulges[ring_number]);
    ++ring_number;
  };
  for (const Polygon& part : basin.shape) {
    cut_next(part.outer);
    for (const Ring& hole : part.holes) cut_next(hole);
  }
  emit_crossed_chords(basin);
  emit_whole_chords_within();
  return result_;
}

void Overlay::cut_ring(const Ring& ring, const std::vector<double>* bulges) {
  edges_.clear();
  edge_events_.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Edge edge{ring[i], ring[(i + 1) % ring.size()], bulges == nullptr ? 0 : (*bulges)[i]};
    if (edge.from == edge.to) continue;
    find_events(static_cast<std::uint32_t>(edges_.size()), edge);
    edges_.push_back(edge);
  }
  if (edges_.empty()) return;
  std::sort(edge_events_.begin(), edge_events_.end(), [](const EdgeEvent& a, const EdgeEvent& b) {
    return std::pair(a.edge, a.along) < std::pair(b.edge, b.along);
  });
  presence_ = presence_at_start();
  emit_ring();
}

// The cell in which the ring starts. It is told by the ring's longest stretch in a single other
// cell: the crossings before that stretch lead from the starting cell into that one. The longest
// stretch is beyond doubt, while nodes closer together than rounding may confuse short stretches
// near them.
Overlay::Presence Overlay::presence_at_start() const {
  const auto length = [&](std::size_t e) { return distance(edges_[e].from, edges_[e].to); };
  double longest = 0;
  for (std::size_t e = 0; e < edges_.size(); ++e) longest += rounding * length(e);
  Presence change_since_start;
  std::optional<PlaceIndex> start;
  double way = 0;  // along the ring to the last crossing
  double way_to_edge = 0;
  std::size_t edge = 0;
  const auto end_stretch = [&](double end) {
    const bool elsewhere = change_since_start.size() == 2 &&
                           change_since_start[0].second + change_since_start[1].second == 0 &&
                           std::abs(change_since_start[0].second) == 1;
    if (elsewhere && end - way > longest) {
      longest = end - way;
      start = change_since_start[change_since_start[0].second < 0 ? 0 : 1].first;
    }
    way = end;
  };
  for (const EdgeEvent& event : edge_events_) {
    if (!event.is_crossing) continue;
    for (; edge < event.edge; ++edge) way_to_edge += length(edge);
    end_stretch(way_to_edge + event.along * length(edge));
    change(change_since_start, event.from, -1);
    change(change_since_start, event.to, 1);
  }
  return {{start ? *start : locate(edges_.front().from), 1}};
}

void Overlay::find_events(std::uint32_t edge_number, const Edge& edge) {
  chord_index_.for_each_near(box_of(edge.from, edge.to),
                             [&](std::uint32_t chord) { add_events(edge_number, edge, chord); });
}

void Overlay::add_events(std::uint32_t edge_number, const Edge& edge, std::uint32_t chord_number) {
  const Chord& chord = diagram_.chords[chord_number];
  const Point from = diagram_.nodes[chord.from];
  const Point to = diagram_.nodes[chord.to];
  const Meeting meeting = meet(edge.from, edge.to, from, to);
  if (meeting.crossing) {
    const Crossing& c = *meeting.crossing;
    crossed_ = true;
    edge_events_.push_back({edge_number, c.along_edge, c.point, true,
                            c.to_left ? chord.right : chord.left,
                            c.to_left ? chord.left : chord.right});
    chord_events_.push_back({chord_number, c.along_chord, c.point, c.entering ? 1 : -1});
  }
  if (!meeting.touches()) return;
  result_.touching = true;
  const auto on_edge = [&](Point p) {
    const double along = distance(edge.from, p) / distance(edge.from, edge.to);
    edge_events_.push_back({edge_number, along, p, false, {}, {}});
  };
  const auto on_chord = [&](Point p) {
    chord_events_.push_back({chord_number, distance(from, p) / distance(from, to), p, 0});
  };
  if (meeting.from_on_edge) on_edge(from);
  if (meeting.to_on_edge) on_edge(to);
  if (meeting.a_on_chord) on_chord(edge.from);
  if (meeting.b_on_chord) on_chord(edge.to);
}

void Overlay::emit_ring() {
  std::size_t next = 0;
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    const Edge& edge = edges_[e];
    Point from = edge.from;
    double begin = 0;
    for (; next < edge_events_.size() && edge_events_[next].edge == e; ++next) {
      put_next_in_order(next);
      const EdgeEvent& event = edge_events_[next];
      emit_edge_piece(edge, begin, from, event.along, event.point);
      from = event.point;
      begin = event.along;
      if (!event.is_crossing) continue;
      change(presence_, event.from, -1);
      change(presence_, event.to, 1);
    }
    emit_edge_piece(edge, begin, from, 1, edge.to);
  }
}

// Swaps the next crossing for the one that leads out of the cell at hand, because crossings at one
// point, or swapped by rounding, may stand in the wrong order.
void Overlay::put_next_in_order(std::size_t next) {
  const EdgeEvent event = edge_events_[next];
  const auto follows = [&](const EdgeEvent& e) {
    return e.is_crossing && presence_.size() == 1 && e.from == presence_.front().first;
  };
  if (!event.is_crossing || follows(event)) return;
  for (std::size_t i = next + 1; i < edge_events_.size() && edge_events_[i].edge == event.edge &&
                                 edge_events_[i].along - event.along < rounding;
       ++i) {
    if (!follows(edge_events_[i])) continue;
    std::swap(edge_events_[next], edge_events_[i]);
    return;
  }
}

void Overlay::emit_edge_piece(const Edge& edge, double begin, Point from, double end, Point to) {
  if (from == to) return;
  const double bulge = edge.bulge == 0 ? 0 : edge.bulge * (bulge_share(end) - bulge_share(begin));
  for (const auto& [place, count] : presence_) {
    for (int i = 0; i < count; ++i) result_.pieces.push_back({place, from, to, bulge});
    for (int i = count; i < 0; ++i) result_.pieces.push_back({place, to, from, -bulge});
  }
}

void Overlay::emit_crossed_chords(const Basin& basin) {
  std::sort(chord_events_.begin(), chord_events_.end(),
            [](const ChordEvent& a, const ChordEvent& b) {
              return std::pair(a.chord, a.along) < std::pair(b.chord, b.along);
            });
  touched_.clear();
  for (std::size_t first = 0; first < chord_events_.size();) {
    std::size_t end = first;
    bool crossed = false;
    while (end < chord_events_.size() && chord_events_[end].chord == chord_events_[first].chord) {
      crossed = crossed || chord_events_[end].step != 0;
      ++end;
    }
    if (crossed) {
      emit_crossed_chord(basin, first, end);
    } else {
      touched_.emplace_back(chord_events_[first].chord, first);
    }
    first = end;
  }
  // The edges between cells are connected (or leave the frame), so if none is crossed, all of them
  // lie within the basin or none does.
  if (crossed_ || diagram_.chords.empty()) return;
  const std::uint32_t node = diagram_.chords.front().from;
  if (is_within(basin, diagram_.nodes[node])) nodes_within_.push_back(node);
}

// Whether a chord begins within the basin, as its crossings tell. If they lead in or out on the
// whole, the chord begins on the other side. Otherwise both beginnings are tried. In the true one
// the chord is in the basin zero times or once everywhere, except on stretches that rounding made.
bool Overlay::begins_within(const Basin& basin, std::size_t first, std::size_t end) const {
  int depth = 0;
  for (std::size_t i = first; i < end; ++i) depth += chord_events_[i].step;
  if (depth == 1 || depth == -1) return depth < 0;

  double wrong_if_outside = 0;
  double wrong_if_within = 0;
  double before = 0;
  depth = 0;
  for (std::size_t i = first; i <= end; ++i) {
    const double along = i == end ? 1 : chord_events_[i].along;
    if (depth < 0 || depth > 1) wrong_if_outside += along - before;
    if (depth < -1 || depth > 0) wrong_if_within += along - before;
    before = along;
    if (i < end) depth += chord_events_[i].step;
  }
  const double difference = wrong_if_outside - wrong_if_within;
  if (std::abs(difference) > rounding) return difference > 0;
  return is_within(basin, diagram_.nodes[diagram_.chords[chord_events_[first].chord].from]);
}

void Overlay::emit_crossed_chord(const Basin& basin, std::size_t first, std::size_t end) {
  const std::uint32_t number = chord_events_[first].chord;
  stamp_[number] = basin_number_;
  const Chord& chord = diagram_.chords[number];
  int depth = begins_within(basin, first, end) ? 1 : 0;
  if (depth != 0) nodes_within_.push_back(chord.from);
  ChordEnd from{0, diagram_.nodes[chord.from]};
  for (std::size_t i = first; i < end; ++i) {
    const ChordEnd to{chord_events_[i].along, chord_events_[i].point};
    emit_chord_piece(number, from, to, depth);
    from = to;
    depth += chord_events_[i].step;
  }
  emit_chord_piece(number, from, {1, diagram_.nodes[chord.to]}, depth);
  if (depth != 0) nodes_within_.push_back(chord.to);
}

// Emits the chords that cross no edge, from the nodes known to lie within the basin along chords
// from node to node.
void Overlay::emit_whole_chords_within() {
  while (!nodes_within_.empty()) {
    throw_if_interrupted();
    const std::uint32_t node = nodes_within_.back();
    nodes_within_.pop_back();
    for (std::uint32_t i = first_chord_at_[node]; i < first_chord_at_[node + 1]; ++i) {
      const std::uint32_t number = chord_at_[i];
      if (stamp_[number] == basin_number_) continue;
      stamp_[number] = basin_number_;
      emit_whole_chord(number);
      const Chord& chord = diagram_.chords[number];
      nodes_within_.push_back(chord.from == node ? chord.to : chord.from);
    }
  }
}

void Overlay::emit_whole_chord(std::uint32_t number) {
  const Chord& chord = diagram_.chords[number];
  ChordEnd from{0, diagram_.nodes[chord.from]};
  if (!result_.touching) {
    if (from.point != diagram_.nodes[chord.to]) result_.whole_chords.push_back(number);
    return;
  }
  const auto touched =
      std::lower_bound(touched_.begin(), touched_.end(), std::pair(number, std::size_t{0}));
  if (touched != touched_.end() && touched->first == number) {
    for (std::size_t i = touched->second;
         i < chord_events_.size() && chord_events_[i].chord == number; ++i) {
      const ChordEnd to{chord_events_[i].along, chord_events_[i].point};
      emit_chord_piece(number, from, to, 1);
      from = to;
    }
  }
  emit_chord_piece(number, from, {1, diagram_.nodes[chord.to]}, 1);
}

void Overlay::emit_chord_piece(std::uint32_t number, ChordEnd from, ChordEnd to, int count) {
  if (from.point == to.point) return;
  if (count < 0) std::swap(from, to);
  const Chord& chord = diagram_.chords[number];
  const double bulge =
      diagram_.bulges.empty()
          ? 0
          : diagram_.bulges[number] * (bulge_share(to.along) - bulge_share(from.along));
  for (int i = 0; i < std::abs(count); ++i) {
    result_.pieces.push_back({chord.left, from.point, to.point, bulge});
    result_.pieces.push_back({chord.right, to.point, from.point, -bulge});
  }
}

// Finds the cell in which a point lies. It goes straight to the place that the diagram takes to be
// near: the first chord on the way, if any, tells on which side of it the point lies. Where chords
// meet on the way, the cells follow each other through them, and the first is the one into which no
// chord leads.
PlaceIndex Overlay::locate(Point p) const {
  struct Step {
    double along;
    PlaceIndex from;
    PlaceIndex to;
  };
  const PlaceIndex guess = diagram_.near(p);
  Point goal = diagram_.places[index(guess)];
  if (diagram_.period > 0) goal.x -= diagram_.period * std::round((goal.x - p.x) / diagram_.period);
  if (goal == p) return guess;
  std::vector<Step> steps;
  double first = 2;
  chord_index_.for_each_near(box_of(p, goal), [&](std::uint32_t number) {
    const Chord& chord = diagram_.chords[number];
    const Meeting meeting = meet(p, goal, diagram_.nodes[chord.from], diagram_.nodes[chord.to]);
    if (!meeting.crossing) return;
    const bool to_left = meeting.crossing->to_left;
    steps.push_back({meeting.crossing->along_edge, to_left ? chord.right : chord.left,
                     to_left ? chord.left : chord.right});
    first = std::min(first, steps.back().along);
  });
  std::erase_if(steps, [&](const Step& step) { return step.along > first + rounding; });
  for (const Step& step : steps) {
    const auto leads_here = [&](const Step& other) { return other.to == step.from; };
    if (std::none_of(steps.begin(), steps.end(), leads_here)) return step.from;
  }
  return guess;
}

}  // namespace thiessen
