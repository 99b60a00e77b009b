#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/point.h"
#include "tessellation/place.h"

namespace thiessen {

/// Stands for none of Diagram::nodes.
inline constexpr std::uint32_t no_node = 0xFFFFFFFFu;

/// A straight piece of the edge between two cells.
struct Chord {
  std::uint32_t from;  ///< a position in Diagram::nodes
  std::uint32_t to;
  PlaceIndex left;  ///< whose cell lies to the left, going from `from` to `to`
  PlaceIndex right;
};

/// The edges of the Thiessen cells of some places, in the coordinates of a study, as far as they
/// come near a frame. Chords meet at nodes of equal number; where an edge leaves the frame it just
/// ends. Whatever is made of a Diagram takes its nodes' coordinates as exact, so that it fits
/// together exactly.
struct Diagram {
  Box frame;
  double period = 0;  ///< after which x repeats: 360 for longitudes; 0 in a plane
  std::vector<Point> nodes;
  std::vector<Chord> chords;
  /// Where chords stand for curved edges: for each the area between the true edge and the chord,
  /// positive where the edge lies to the chord's right, as in Basin::bulges. Empty where they are
  /// as near to them as they have to be.
  std::vector<double> bulges;
  /// A place whose cell is at or near a point of the frame, and that place's position in the
  /// frame's coordinates: where a search for the point's cell may start.
  std::function<PlaceIndex(Point)> near;
  std::vector<Point> places;
  /// For each place the place whose cell it has: itself, but where rounding cannot tell it from
  /// another, less than a micrometre away, with which it shares one cell.
  std::vector<PlaceIndex> cell_of;
  /// Pairs of places whose cells have an edge in common; also some, far from the frame, whose cells
  /// may. Those that share a cell have pairs too.
  std::vector<std::pair<PlaceIndex, PlaceIndex>> neighbours;
};

}  // namespace thiessen
