#include "rainfall/methods/value_bands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "basin/ring_linking.h"

namespace thiessen {
namespace {

struct Corner {
  Point at;
  double value = 0;
  bool is_within = true;
  /// Whether the edge from here to the next corner bounds the ground; if not, the triangle on its
  /// other side goes on with what is there.
  bool bounds = false;
};

/// A convex piece of a triangle, counter-clockwise. A triangle that is cut three times has six
/// corners.
class Piece {
 public:
  void add(const Corner& corner) { corners_[count_++] = corner; }
  std::size_t size() const { return count_; }
  const Corner& operator[](std::size_t i) const { return corners_[i]; }
  const Corner& after(std::size_t i) const { return corners_[i + 1 < count_ ? i + 1 : 0]; }

 private:
  std::array<Corner, 6> corners_;
  std::size_t count_ = 0;
};

Corner between(const Corner& a, const Corner& b, double share) {
  if (share == 1) return {b.at, b.value, true, false};  // to the bit, as from other edges
  return {{a.at.x + share * (b.at.x - a.at.x), a.at.y + share * (b.at.y - a.at.y)},
          a.value + share * (b.value - a.value),
          true,
          false};
}

/// What is left of a piece on one side of a cut. `crossing(a, b)` is the corner on the cut between
/// two corners on its two sides, the same whichever triangle asks.
template <typename IsKept, typename Crossing>
Piece kept_part(const Piece& piece, IsKept&& is_kept, Crossing&& crossing) {
  Piece kept;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Corner& here = piece[i];
    const Corner& next = piece.after(i);
    const bool keeps_here = is_kept(here);
    const bool keeps_next = is_kept(next);
    if (keeps_here) kept.add(here);
    if (keeps_here == keeps_next) continue;
    Corner cut = crossing(here, next);
    // Out of the part the cut is its bound, back into it the old edge goes on.
    cut.bounds = keeps_here || here.bounds;
    kept.add(cut);
  }
  return kept;
}

class BandTracing {
 public:
  BandTracing(const PixelValues& surface, double low, double high)
      : surface_(surface), low_(low), high_(high) {}

  std::vector<DirectedEdge> edges() && {
    for (int row = 0; row + 1 < surface_.grid.rows; ++row) {
      throw_if_interrupted();
      for (int column = 0; column + 1 < surface_.grid.columns; ++column) trace(column, row);
    }
    return std::move(edges_);
  }

 private:
  std::size_t pixel(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(surface_.grid.columns) +
           static_cast<std::size_t>(column);
  }
  double value(int column, int row) const { return surface_.values[pixel(column, row)]; }
  bool is_within(int column, int row) const {
    return surface_.is_within.empty() || surface_.is_within[pixel(column, row)] != 0;
  }
  Corner corner(int column, int row) const {
    return {surface_.grid.centre(column, row), value(column, row), is_within(column, row), false};
  }
  /// Whether the square south-east of a centre has values at all its corners.
  bool is_ground(int column, int row) const {
    return column >= 0 && row >= 0 && column + 1 < surface_.grid.columns &&
           row + 1 < surface_.grid.rows && !std::isnan(value(column, row)) &&
           !std::isnan(value(column + 1, row)) && !std::isnan(value(column, row + 1)) &&
           !std::isnan(value(column + 1, row + 1));
  }

  void trace(int column, int row) {
    if (!is_ground(column, row)) return;
    const double north_west = value(column, row);
    const double north_east = value(column + 1, row);
    const double south_west = value(column, row + 1);
    const double south_east = value(column + 1, row + 1);
    const auto [least, largest] = std::minmax({north_west, north_east, south_west, south_east});
    if (largest < low_ || least >= high_) return;
    const std::array sides{!is_ground(column - 1, row), !is_ground(column, row + 1),
                           !is_ground(column + 1, row), !is_ground(column, row - 1)};
    const int within = is_within(column, row) + is_within(column + 1, row) +
                       is_within(column, row + 1) + is_within(column + 1, row + 1);
    if (within == 0) return;
    const bool has_bound = std::find(sides.begin(), sides.end(), true) != sides.end();
    if (within == 4 && !has_bound && least >= low_ && largest < high_) return;
    std::array corners{corner(column, row), corner(column, row + 1), corner(column + 1, row + 1),
                       corner(column + 1, row)};
    for (std::size_t i = 0; i < 4; ++i) corners[i].bounds = sides[i];
    const bool from_north_west =
        std::abs(north_west - south_east) <= std::abs(north_east - south_west);
    trace_half(corners, from_north_west ? 0 : 1);
    trace_half(corners, from_north_west ? 2 : 3);
  }

  /// Traces the triangle of a corner and the two after it; the last side is the diagonal.
  void trace_half(const std::array<Corner, 4>& corners, std::size_t first) {
    Piece piece;
    for (std::size_t i = 0; i < 3; ++i) {
      Corner corner = corners[(first + i) % 4];
      corner.bounds = corner.bounds && i < 2;
      piece.add(corner);
    }
    piece = kept_part(
        piece, [](const Corner& c) { return c.is_within; },
        [&](const Corner& a, const Corner& b) {
          return a.is_within ? end_of_ground(a, b) : end_of_ground(b, a);
        });
    piece = kept_part(
        piece, [&](const Corner& c) { return c.value >= low_; },
        [&](const Corner& a, const Corner& b) { return at_level(a, b, low_); });
    piece = kept_part(
        piece, [&](const Corner& c) { return c.value < high_; },
        [&](const Corner& a, const Corner& b) { return at_level(a, b, high_); });
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (piece[i].bounds && piece[i].at != piece.after(i).at)
        edges_.push_back({piece[i].at, piece.after(i).at});
    }
  }

  Corner end_of_ground(const Corner& inner, const Corner& outer) const {
    constexpr int halvings = 20;
    double last = 0;
    double step = 0.5;
    for (int i = 0; i < halvings; ++i, step /= 2) {
      if (surface_.holds(between(inner, outer, last + step).at)) last += step;
    }
    return between(inner, outer, last);
  }

  static Corner at_level(const Corner& a, const Corner& b, double level) {
    if (std::tie(b.at.x, b.at.y) < std::tie(a.at.x, a.at.y)) return at_level(b, a, level);
    Corner cut = between(a, b, (level - a.value) / (b.value - a.value));
    cut.value = level;
    return cut;
  }

  const PixelValues& surface_;
  double low_;
  double high_;
  std::vector<DirectedEdge> edges_;
};

}  // namespace

MultiPolygon ground_between(const PixelValues& surface, double low, double high) {
  return link_rings(BandTracing(surface, low, high).edges());
}

}  // namespace thiessen
