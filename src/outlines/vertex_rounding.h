#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <unordered_map>

#include "geometry/polygon.h"

namespace thiessen {

/// The number of decimals with which each vertex of a set of cells is written. Cells that share a
/// vertex write it alike, so neighbours keep sharing their edges.
class VertexRounding {
 public:
  /// Begins with `decimals`, and gives three more, and so on up to all digits, to the vertices of
  /// every cell that would collapse, turn over or cross itself when rounded. Cost: a check of
  /// validity for each cell, and again each time a cell's vertices get more.
  VertexRounding(std::span<const MultiPolygon> cells, int decimals);
  /// Writes every vertex with all digits.
  VertexRounding() = default;

  /// Appends a ring as `[[x,y],...]`, closed; neighbouring vertices that fall together are written
  /// once.
  void append(std::string& out, const Ring& ring) const;

 private:
  static constexpr int every_digit = -1;

  struct Hash {
    std::size_t operator()(Point point) const;
  };

  int level_of(Point point) const;
  Point rounded(Point point) const;
  Ring rounded(const Ring& ring) const;
  bool holds(const MultiPolygon& cell) const;
  void refine(const MultiPolygon& cell, int level);
  void append_number(std::string& out, double value, int level) const;

  int decimals_ = every_digit;
  std::unordered_map<Point, int, Hash> levels_;  ///< of the vertices that need more decimals
};

/// The decimals of a degree to write for edges that may lie so many metres off: 7 for 0.1 m, and
/// one more for each factor of ten less.
int decimals_for(double tolerance);

}  // namespace thiessen
