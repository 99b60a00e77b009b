#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/point.h"
#include "tessellation/place.h"

namespace thiessen {

/// The index that stands for none of Diagram::nodes.
inline constexpr std::uint32_t no_node = 0xFFFFFFFFu;

/// A straight piece of the edge between two cells.
struct Chord {
  std::uint32_t from;  ///< the node it starts at, an index into Diagram::nodes
  std::uint32_t to;
  PlaceIndex left;  ///< the place whose cell lies to the left, going from `from` to `to`
  PlaceIndex right;
};

/// Whether Diagram::neighbours are wanted of a diagram, or left empty.
enum class Neighbours { wanted, left_out };

/// The edges of the Thiessen cells of some places, in the coordinates of a study, as far as they
/// come near a frame. Chords that meet have the same node; where an edge leaves the frame, it just
/// ends. All code that uses a Diagram takes the nodes' coordinates as exact, so that what it makes
/// fits together exactly.
struct Diagram {
  Box frame;
  double period = 0;  ///< the period after which x repeats: 360 for longitudes; 0 in a plane
  std::vector<Point> nodes;
  std::vector<Chord> chords;
  /// The area between the true edge and its chord, for each chord, where chords stand for curved
  /// edges. It is positive where the edge lies to the chord's right, as in Basin::bulges. The list
  /// is empty where the chords are as near to the edges as they have to be.
  std::vector<double> bulges;
  /// Returns a place whose cell is at or near a point of the frame, so that a search for the
  /// point's cell may start there.
  std::function<PlaceIndex(Point)> near;
  /// The places' positions in the frame's coordinates.
  std::vector<Point> places;
  /// The place that owns the cell of each place. This is the place itself, unless rounding cannot
  /// tell it from another one less than a micrometre away: then the two share one cell.
  std::vector<PlaceIndex> cell_of;
  /// The pairs of places whose cells have an edge in common. Far from the frame there are also some
  /// pairs whose cells only may have one. Places that share a cell have pairs too.
  std::vector<std::pair<PlaceIndex, PlaceIndex>> neighbours;
};

}  // namespace thiessen
