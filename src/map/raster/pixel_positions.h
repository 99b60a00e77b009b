#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "earth/nearest/nearest_places.h"
#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"

namespace thiessen {

/// Where the centres of a block's pixels lie in space, as far as that can be said by a plane.
struct PixelPlane {
  Direction first;  ///< the centre of the block's first pixel
  Direction east;   ///< from a pixel's centre to that of its eastern neighbour
  Direction south;
  double off = 0;  ///< an upper bound on how far the centres are from the plane's points

  double pixel() const { return std::max(length(east), length(south)); }
};

/// Approximates where the pixels of a block lie in space by polynomials of the fourth degree in
/// columns and rows. They pass through the true positions at 5 x 5 Chebyshev points of the block,
/// and are compared with true positions at 4 x 4 points between these.
class PixelPositions {
 public:
  /// Fits the polynomials to a block. Nothing where they are off by more than a 500th of a pixel,
  /// as they are where the projection is interrupted or comes to its end, or where the size and
  /// direction of pixels change by more than a third within the block. Cost: 41 positions.
  static std::optional<PixelPositions> fit(const PixelGrid& grid, const PixelBlock& block,
                                           const PointMapping& to_study,
                                           const NearestPlaces& places);

  /// A ball that holds the centres of all pixels of `part`, which must be a part of the block
  /// fitted. Its radius allows for polynomials that are off by four times the largest difference
  /// found, and for the rounding of positions.
  Ball ball(const PixelBlock& part) const;
  /// The plane that touches the polynomials in the middle of `part`, which must be a part of the
  /// block fitted. It is off by half the second differences at most, and by what the balls allow
  /// for.
  PixelPlane plane(const PixelBlock& part) const;

 private:
  static constexpr std::size_t terms = 5;
  using Row = std::array<Direction, terms>;

  /// A position, and how it changes from the block's middle to its edges.
  struct Tangent {
    Direction position;
    Direction east;
    Direction south;
  };

  explicit PixelPositions(const PixelBlock& block) : block_(block) {}
  void pass_through(const std::vector<Direction>& nodes);
  double farthest_off(const std::vector<Direction>& between) const;
  void bound_tangents();
  void bound_curvature();
  bool is_even() const;
  Direction position(double east, double south) const;
  Tangent tangent(double east, double south) const;

  PixelBlock block_;
  Direction origin_;
  /// The terms by power of south, then of east; both run from -1 to 1 in the block.
  std::array<Row, terms> terms_;
  Tangent middle_;
  double east_varies_ = 0;
  double south_varies_ = 0;
  double off_ = 0;
  /// Upper bounds on the second derivatives within the block.
  double bends_east_ = 0;
  double bends_across_ = 0;
  double bends_south_ = 0;
};

}  // namespace thiessen
