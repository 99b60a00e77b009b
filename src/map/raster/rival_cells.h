#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "earth/nearest/nearest_places.h"
#include "geometry/pixel_grid.h"
#include "geometry/point.h"
#include "map/raster/pixel_positions.h"

namespace thiessen {

/// The cells of some rivals in a block of pixels whose centres lie near a plane of space. There the
/// difference of the squares of the distances to two places is linear in columns and rows, so that
/// cells are convex polygons; and where it exceeds what is certain, the nearer place is told. The
/// centre of the block's first pixel is at 0, 0; x counts columns and y rows. Rivals are numbered
/// in the order in which they were given.
///
/// Law: a centre that cannot be told is within `untold_within` of an edge between two cells, in
/// columns and in rows.
class RivalCells {
 public:
  /// With more rivals than this it is cheaper to quarter the block first.
  static constexpr std::size_t most = 48;
  static constexpr double untold_within = 0.125;

  /// Lays the cells. `rivals` must hold every place that may be nearest to a centre of the block,
  /// `most` of them at most. False where the cells are too small, or the centres too far from the
  /// plane, for the law to hold; the cells are of no use then. Cost: the square of the rivals.
  bool lay(const PixelPlane& plane, const PixelBlock& block, const NearestPlaces& places,
           std::span<const PlaceIndex> rivals);

  static constexpr std::size_t most_corners = 16;
  static constexpr std::uint8_t nobody = 0xFF;
  /// A cell, cut off a pixel outside of the block's outer centres.
  struct Cell {
    std::array<Point, most_corners> corners;
    /// The cell beyond the edge that leads on from each corner; nobody where the cell was cut off.
    std::array<std::uint8_t, most_corners> beyond;
    std::size_t count = 0;
    std::size_t rival = 0;

    std::span<const Point> polygon() const { return std::span(corners).first(count); }
    Point next(std::size_t i) const { return corners[i + 1 < count ? i + 1 : 0]; }
    double doubled_area() const;
  };
  /// The cells of the rivals that others do not beat throughout the block.
  std::span<const Cell> cells() const { return cells_; }

  /// A number that changes by as much from each column, and from each row, to the next.
  struct Linear {
    double at;  ///< at the first pixel
    double east;
    double south;

    double value(Point p) const { return at + east * p.x + south * p.y; }
  };

  /// A part of an edge between two cells, and the rivals that may be nearest to centres no farther
  /// from it than `reach`, in columns and in rows.
  class Edge {
   public:
    Edge(const RivalCells& cells, std::size_t cell, std::size_t beyond, Point from, Point to,
         double reach);

    /// How many rivals these are, and each of them.
    std::size_t count() const { return count_; }
    std::size_t rival(std::size_t i) const { return rivals_[i]; }
    /// Which of them is nearest to such a centre for certain, or nothing.
    std::optional<std::size_t> nearest(int column, int row) const {
      const Point centre{static_cast<double>(column), static_cast<double>(row)};
      std::size_t nearest = 0;
      double least = 0;
      double second = HUGE_VAL;
      for (std::size_t i = 1; i < count_; ++i) {
        const double square = forms_[i].value(centre);
        const bool is_nearer = square < least;
        second = is_nearer ? least : std::min(second, square);
        nearest = is_nearer ? i : nearest;
        least = is_nearer ? square : least;
      }
      if (!(second - least > certain_)) return {};
      return nearest;
    }

   private:
    std::array<Linear, most> forms_;
    std::array<std::uint8_t, most> rivals_;
    std::size_t count_ = 0;
    double certain_ = 0;
  };

 private:
  struct Form {
    Linear square;  ///< of the rival's distance, less that of the first rival's
    Direction way;  ///< from the first pixel to the place
    std::uint8_t rival;
  };
  static Linear difference(const Form& a, const Form& b) {
    return {a.square.at - b.square.at, a.square.east - b.square.east,
            a.square.south - b.square.south};
  }

  void leave_out_beaten(const PixelBlock& block);
  bool lay_cell(std::size_t rival, const PixelBlock& block);
  bool cut(std::uint8_t other, const Linear& lead);
  double certain_between(const Form& a, const Form& b) const {
    const Direction apart = a.way - b.way;
    return certain_.at(dot(apart, apart)) + rounding_;
  }

  CertainDifference certain_;
  double rounding_ = 0;
  double largest_certain_ = 0;
  std::vector<Form> forms_;
  std::vector<Cell> cells_;
  std::array<Cell, 2> drafts_;
  Cell* cell_ = &drafts_[0];
  Cell* kept_ = &drafts_[1];
};

}  // namespace thiessen
