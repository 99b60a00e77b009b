#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geometry/point.h"

namespace thiessen {

/// A Voronoi vertex as a printed topology table tells of it, by the numbers that its user knows.
template <int Dimension>
struct NumberedVertex {
  using Numbers = std::array<std::uint64_t, std::size_t{Dimension} + 1>;

  std::uint64_t number = 0;
  Numbers forming{};
  Numbers neighbours{};  ///< neighbour i lies across from forming point i; 0 where there is none
  std::size_t line = 0;  ///< the line of the file that tells of it
};

/// What a printed topology table tells: its points in the order of their numbers, and its vertices.
template <int Dimension>
struct NumberedTable {
  std::string file;  ///< the file as the user named it
  std::vector<std::uint64_t> numbers;
  std::vector<PositionIn<Dimension>> positions;
  std::vector<NumberedVertex<Dimension>> vertices;  ///< none where the table has points alone
};

/// Reads a topology table as write_topology_table writes it, line by line. Points and vertices may
/// stand in any order; blank lines, and those that begin with a #, are passed over. Centres and
/// radii have to be there, but are not kept, as they are computed from the points. -0 becomes 0.
template <int Dimension>
class TopologyTableReader {
 public:
  explicit TopologyTableReader(std::string file) : file_(std::move(file)) {}

  /// Whether a file that begins with this line is a topology table: it tells of a point.
  static bool begins_table(std::string_view line);

  /// Takes the next line, which has this number.
  void take(std::string_view line, std::size_t number);
  /// What was read. Throws Error with every bad line: one of another form, a number that is none, a
  /// coordinate outside the exact range, a number that stands twice, two points at one position.
  NumberedTable<Dimension> table() &&;

 private:
  struct NumberedPoint {
    std::uint64_t number;
    PositionIn<Dimension> position;
    std::size_t line;
  };

  void take_point(std::span<const std::string_view> words, std::size_t line);
  void take_vertex(std::span<const std::string_view> words, std::size_t line);
  void refuse_repeated();
  void complain(std::size_t line, std::string text, std::string hint = {});

  std::string file_;
  Complaints complaints_;
  std::vector<NumberedPoint> points_;
  std::vector<NumberedVertex<Dimension>> vertices_;
};

}  // namespace thiessen
