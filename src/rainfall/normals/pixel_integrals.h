#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <variant>
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
/// figures of the window's rows. Cost: 15 nanoseconds a pixel that an edge crosses, and 2 for each
/// further band. Memory: a byte a pixel and band beside the values, as much again where some have
/// none, and a byte a pixel where pixels of a row differ.
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
  /// The areas by what they are, so that who goes from pixel to pixel calls no virtual function.
  using AnyAreas = std::variant<const EqualPixels*, const PixelsInDegrees*, const PixelsOfPlane*>;
  template <typename Areas, typename Value>
  class EdgeWalk;
  template <typename Areas, typename Value>
  class OneBand;
  template <typename Areas, typename Value>
  class ManyBands;

  static AnyAreas known(const PixelAreas& areas);
  void sum_up();
  template <typename Value>
  void sum_up_row(std::size_t row, const Value* values, std::vector<double>& sums);
  /// The sums over the pixels of a row before a block of columns.
  const double* before(std::size_t row, std::size_t block) const {
    return &before_[(row * blocks_ + block) * sums_];
  }

  WindowValues values_;
  std::vector<double> references_;
  std::unique_ptr<const PixelAreas> areas_;
  AnyAreas known_areas_;
  std::size_t blocks_;
  bool is_complete_;  // whether every pixel has a value in every band
  bool vary_;         // whether pixels of a row have scales of their own
  std::size_t sums_;  // how many figures a block has
  // By row and block of columns, the sums over all columns before the block, side by side, for they
  // are far from each other in memory else: of each band's excess, of what each covers where pixels
  // lack values, and of scales where these vary.
  std::vector<double> before_;
};

}  // namespace thiessen
