#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// The number of decimals with which each vertex of a set of cells is written. Cells that share a
/// vertex write it alike, so neighbours keep sharing their edges.
class VertexRounding {
 public:
  /// Begins with `decimals`, and gives one more, then four, seven and all digits, to the vertices
  /// of every cell that would collapse, turn over or cross itself when rounded. Cost: a check of
  /// validity for each cell, and again each time a cell's vertices get more.
  VertexRounding(std::span<const MultiPolygon> cells, int decimals);
  /// Writes every vertex with all digits.
  VertexRounding() = default;

  /// The cells that one more decimal was not enough for: somewhere they are narrower than that.
  const std::vector<std::size_t>& narrow() const { return narrow_; }
  /// The cells that are no valid shape even with all digits.
  const std::vector<std::size_t>& faulty() const { return faulty_; }

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
  static void append_all_digits(std::string& out, const Ring& ring);

  int decimals_ = every_digit;
  std::unordered_map<Point, int, Hash> levels_;  ///< of the vertices that need more decimals
  std::vector<std::size_t> narrow_;
  std::vector<std::size_t> faulty_;
};

/// Whether a shape is valid and each of its rings runs the way that it has to: outer rings
/// counter-clockwise, holes clockwise. A shape without polygons is.
bool is_writable(const MultiPolygon& shape);

/// The decimals of a degree to write for edges that may lie so many metres off: 7 for 0.1 m, and
/// one more for each factor of ten less.
int decimals_for(double tolerance);

}  // namespace thiessen
