#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "basin/basin.h"
#include "basin/chord_index.h"
#include "diagram/diagram.h"

namespace thiessen {

/// A directed straight piece of the boundary of one cell's part in a basin; the part lies to its
/// left.
struct BoundaryPiece {
  PlaceIndex place;
  Point from;
  Point to;
  /// The area in square metres between the true edge, of the basin or of the cell, and this piece:
  /// see Basin::bulges.
  double bulge = 0;
};

/// The boundaries of all cells' parts in one basin. Each part's pieces form closed lines in spite
/// of rounding: at every point as many begin as end. Where `touching` is set (an edge of the basin
/// runs along a chord), pieces may lie on each other in opposite directions; they cancel.
struct CutBasin {
  std::vector<BoundaryPiece> pieces;
  /// Chords of the diagram that lie in the basin as they are, from end to end: each stands for the
  /// two pieces that pieces_of returns, which would take 24 times as much memory. There are none
  /// where `touching` is set.
  std::vector<std::uint32_t> whole_chords;
  bool touching = false;
};

/// The pieces of a chord that lies in a basin as it is: of the cell to its left, and of that to its
/// right.
inline std::pair<BoundaryPiece, BoundaryPiece> pieces_of(const Diagram& diagram,
                                                         std::uint32_t chord) {
  const Chord& c = diagram.chords[chord];
  const Point from = diagram.nodes[c.from];
  const Point to = diagram.nodes[c.to];
  const double bulge = diagram.bulges.empty() ? 0 : diagram.bulges[chord];
  return {{c.left, from, to, bulge}, {c.right, to, from, -bulge}};
}

/// Lays basins over the cells of a diagram. The diagram must outlive it. Each thread needs one of
/// its own.
///
/// All decisions are exact (see Crossing), so there is no tolerance and no special case. Cost: n
/// log n in the chords to build; for a basin log n for each of its edges, and in proportion to the
/// crossings and to the chords within; nothing for what the basin does not touch. Memory: 60 bytes
/// a chord, and 20 less where few edges are laid over them.
class Overlay {
 public:
  /// `searches` are few where all basins together have but a few edges.
  explicit Overlay(const Diagram& diagram, Searches searches = Searches::many);

  /// Cuts a basin along the edges of the cells. Requires a valid basin inside the diagram's frame.
  /// The result stands until the next call, and whoever asks may change it until then: a copy of
  /// millions of pieces would take longer than cutting them.
  CutBasin& cut(const Basin& basin);

 private:
  struct Edge {
    Point from;
    Point to;
    double bulge;
  };
  struct EdgeEvent {  // a crossing, or only a node on the edge
    std::uint32_t edge;
    double along;
    Point point;
    bool is_crossing;
    PlaceIndex from;
    PlaceIndex to;
  };
  struct ChordEvent {
    std::uint32_t chord;
    double along;
    Point point;
    int step;  // 1 into the basin, -1 out of it, 0 where only a node lies on the chord
  };
  using Presence = std::vector<std::pair<PlaceIndex, int>>;

  void cut_ring(const Ring& ring, const std::vector<double>* bulges);
  void find_events(std::uint32_t edge_number, const Edge& edge);
  void add_events(std::uint32_t edge_number, const Edge& edge, std::uint32_t chord_number);
  Presence presence_at_start() const;
  void emit_ring();
  void put_next_in_order(std::size_t next);
  void emit_edge_piece(const Edge& edge, double begin, Point from, double end, Point to);
  void emit_crossed_chords(const Basin& basin);
  void emit_crossed_chord(const Basin& basin, std::size_t first, std::size_t end);
  bool begins_within(const Basin& basin, std::size_t first, std::size_t end) const;
  void emit_whole_chords_within();
  void emit_whole_chord(std::uint32_t number);
  struct ChordEnd {
    double along;
    Point point;
  };
  void emit_chord_piece(std::uint32_t number, ChordEnd from, ChordEnd to, int count);
  PlaceIndex locate(Point p) const;

  const Diagram& diagram_;
  ChordIndex chord_index_;
  std::vector<std::uint32_t>
      first_chord_at_;  // chords by node: chord_at_[first_chord_at_[node]] ...
  std::vector<std::uint32_t> chord_at_;

  CutBasin result_;
  std::vector<Edge> edges_;  // of the ring at hand
  std::vector<EdgeEvent> edge_events_;
  // The cells that the boundary is in: one, except between crossings that rounding swapped.
  Presence presence_;
  std::vector<ChordEvent> chord_events_;
  std::vector<std::pair<std::uint32_t, std::size_t>>
      touched_;                       // chords with nodes on them, and their first event
  bool crossed_ = false;              // whether any chord is crossed
  std::vector<std::uint32_t> stamp_;  // by chord: the last basin that emitted it
  std::uint32_t basin_number_ = 0;
  std::vector<std::uint32_t> nodes_within_;
};

}  // namespace thiessen
