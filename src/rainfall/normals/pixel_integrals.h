#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "geometry/point.h"
#include "rainfall/normals/pixel_areas.h"
#include "rainfall/normals/window_values.h"

namespace thiessen {

/// Integrals of a raster over ground, by the edges that bound it. A pixel is a polygon of one
/// value: what the ground has of it counts exactly, and no centre is looked at.
///
/// Each edge adds the integral over what lies to its left in its rows, from the window's left edge
/// (Green's theorem); summed round the ground all that lies outside cancels. Positions are in
/// pixels (see PixelAreas), beyond the window there are no values.
///
/// An edge adds to 1 + 2 x bands figures: the area; then for each band the integral of the value
/// less the band's reference, and the area that has a value. A band that is equal to its reference
/// all over has a first figure that is exactly 0. Accuracy: that of PixelAreas, and 1e-16 of the
/// figures of the window's rows. Cost: 20 nanoseconds a pixel that an edge crosses and a band.
/// Memory: a byte a pixel and band beside the values, as much again where some have none, and once
/// more where pixels of a row differ.
class PixelIntegrals {
 public:
  /// Requires a reference for each band.
  PixelIntegrals(WindowValues values, std::vector<double> references,
                 std::unique_ptr<const PixelAreas> areas);

  std::size_t bands() const { return values_.bands(); }
  std::size_t figures() const { return 1 + 2 * bands(); }
  static std::size_t excess_of(std::size_t band) { return 1 + 2 * band; }
  static std::size_t covered_of(std::size_t band) { return 2 + 2 * band; }
  double reference(std::size_t band) const { return references_[band]; }

  /// Adds a straight edge. Round ground that lies to the left of its edges, where columns are
  /// drawn to the right and rows upwards, the figures add up to its own.
  /// Law: the figures of the edge back are those of the edge there with the other sign, bit for
  /// bit.
  void add_edge(Point from, Point to, std::span<double> figures) const;
  /// Adds ground of some area that is small against a pixel and lies at a point.
  void add_at(Point at, double area, std::span<double> figures) const;
  /// The area of a pixel at a point.
  double pixel_area(Point at) const;
  /// The value at a point; NaN where there is none.
  double value_at(Point at, std::size_t band) const;

 private:
  /// A stretch of an edge that lies in one row of pixels.
  struct Stretch {
    std::size_t row;
    Point from;
    Point to;
    double from_ordinate;
    double to_ordinate;
  };
  /// A piece of a stretch in one pixel.
  struct Piece {
    double rise;    ///< of the ordinate from its western to its eastern end
    double beside;  ///< what lies between it and the pixel's left edge, without the pixel's scale
  };
  class Running;

  void add_stretch(const Stretch& stretch, double sign, std::span<double> figures) const;
  template <typename Take>
  void for_each_piece(const Stretch& stretch, const Take& take) const;
  void sum_up();
  void sum_up_row(std::size_t band, std::size_t row);

  WindowValues values_;
  std::vector<double> references_;
  std::unique_ptr<const PixelAreas> areas_;
  std::size_t blocks_;
  bool is_complete_;  // whether every pixel has a value in every band
  bool vary_;         // whether pixels of a row have scales of their own
  std::size_t sums_;  // how many figures a block has
  // By band, row and block of columns, the sums over all columns before the block, side by side,
  // for they are far from each other in memory else: of the excess, of what is covered where pixels
  // lack values, and of scales where these vary.
  std::vector<double> before_;
};

}  // namespace thiessen
