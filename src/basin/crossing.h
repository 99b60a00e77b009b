#pragma once

#include <optional>

#include "geometry/point.h"

namespace thiessen {

/// The crossing of a basin's edge and a chord between two cells.
///
/// Basins are treated as if shifted by (epsilon, epsilon^2), with epsilon infinitely small. Then no
/// vertex lies on a chord, no node lies on a basin's edge, and an edge along a chord runs beside it
/// (Edelsbrunner and Muecke, Simulation of simplicity, 1990). Every basin is shifted alike, so
/// neighbours still share their edges, and what the shift adds or takes has no area.
struct Crossing {
  Point point;        ///< the same bits in whichever directions the two run
  double along_edge;  ///< from 0 to 1
  double along_chord;
  bool to_left;   ///< the edge passes from the chord's right to its left
  bool entering;  ///< going along the chord, the basin (to the left of its edge) begins here
};

/// How an edge a→b of a basin and a chord from→to lie relative to each other.
struct Meeting {
  std::optional<Crossing> crossing;
  bool from_on_edge = false;  ///< the chord's end lies exactly on the edge
  bool to_on_edge = false;
  bool a_on_chord = false;  ///< the edge's end lies exactly on the chord
  bool b_on_chord = false;

  bool touches() const { return from_on_edge || to_on_edge || a_on_chord || b_on_chord; }
};

/// Computes how a basin's edge a→b and a chord from→to lie. Requires coordinates in the exact range
/// of predicates.h, a != b and from != to. Exact except for the crossing's coordinates, which are
/// within 4 roundings of the true ones.
Meeting meet(Point a, Point b, Point from, Point to);

}  // namespace thiessen
