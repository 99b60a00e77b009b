#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rainfall/errors/sites.h"

namespace thiessen {

/// How readings differ with distance: half the mean square difference of two gauges' readings, in
/// units of the field's variance, which is 1 less their correlation.
///
/// nugget + sill x (1 - exp(-(d / range)^exponent)), with an exponent of (0, 2]: 1 is the
/// exponential, 2 the Gaussian; or nugget + sill x (1.5 u - 0.5 u^3), u = d / range up to 1: the
/// spherical. All are valid in space for any nugget, sill and range that are not negative: no mean
/// square of any sum of readings is negative. Source: J.-P. Chiles, P. Delfiner, Geostatistics,
/// 2012, section 2.5.
struct VariogramModel {
  enum class Shape { stable, spherical };

  Shape shape = Shape::stable;
  double nugget = 0;  ///< what remains at no distance: gauges' errors, and rain smaller than gaps
  double sill = 0;    ///< what distance adds
  double range = 1;   ///< in the unit of distances
  double exponent = 1;

  /// From 0 to 1: sill x this is what distance adds.
  double rise(double distance) const;
  /// Of two different gauges.
  double operator()(double distance) const { return nugget + sill * rise(distance); }
};

/// A model in a table of 128 straight pieces an octave of the distance's square, so that a look-up
/// takes neither a root nor a power: 2 nanoseconds. Accuracy: 5e-6 of the model, but for distances
/// within 1e-6 of the longest, which have the nugget and a straight rise. Memory: 80 kB.
class Variogram {
 public:
  /// `longest`: beyond all distances that are asked for but a few, which cost more.
  Variogram(const VariogramModel& model, double longest);

  const VariogramModel& model() const { return model_; }
  /// Of two different gauges, or of a gauge and a point: a point has no error of its own, but the
  /// nugget is the gauge's.
  double operator()(Direction a, Direction b) const { return at_square(square_distance(a, b)); }
  double at_square(double square) const {
    const std::size_t i = piece_of(square) - first_;
    if (i >= pieces_.size()) return beyond(square);
    const Piece& piece = pieces_[i];
    return piece.value + piece.slope * (square - piece.begin);
  }

 private:
  static constexpr unsigned piece_bits = 7;
  static constexpr unsigned shift = 52 - piece_bits;  // of a double's mantissa

  static std::size_t piece_of(double square) {
    return std::bit_cast<std::uint64_t>(square) >> shift;
  }
  static double begin_of(std::size_t piece) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(piece) << shift);
  }
  double beyond(double square) const;

  struct Piece {
    double begin;
    double value;
    double slope;
  };
  VariogramModel model_;
  std::vector<Piece> pieces_;
  std::size_t first_ = 0;  // the number of the first octave's first piece
  double lowest_ = 0;
};

}  // namespace thiessen
