#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "geometry/point.h"
#include "rainfall/normals/elevation_fit.h"

namespace thiessen {

/// The normals of a window of pixels whose elevations are known, from what a fit tells at the nodes
/// of a lattice round it. Between nodes ln N at elevation 0, its slope and the nearest gauge's ln N
/// are taken to be bilinear. Safe for several threads at once.
class ElevationPatch {
 public:
  /// A row of values, evenly apart: where its first one lies in the lattice's raster, in pixels,
  /// and how many pixels the next one is away. The middle of the first pixel is 0.5, 0.5.
  struct Row {
    Point first;
    double apart = 1;
  };
  /// A pixel of the lattice's raster, or the number of a node.
  struct Corner {
    std::int64_t column;
    std::int64_t row;
  };

  std::size_t months() const { return months_; }
  /// The normals of a row: those of each month in turn, one for each elevation; NaN where that is
  /// NaN. `spreads` are the variances of the elevations for which one stands: the normal is then
  /// the mean of theirs, to the second order. `held` becomes true where some month's is held by the
  /// nearest gauge's.
  void fill(const Row& row, std::span<const double> elevations, std::span<const double> spreads,
            std::span<double> normals, std::span<char> held) const;
  /// The variance of ln N at a position and elevation, as it is at the nearest node.
  double variance(Point at, double elevation, std::size_t month) const;

 private:
  friend class ElevationLattice;
  const ToldNormal& node(std::size_t i, std::size_t j, std::size_t month) const {
    return nodes_[(j * nodes_in_row_ + i) * months_ + month];
  }

  Corner first_node_{};  // its number
  std::size_t columns_apart_ = 1;
  std::size_t rows_apart_ = 1;
  std::size_t nodes_in_row_ = 0;
  std::size_t months_ = 1;
  std::vector<ToldNormal> nodes_;  // row by row, month by month
};

/// What a fit tells at nodes so many pixels of a raster apart, each of which is computed once for
/// all windows. Cost: 20 microseconds a node and month.
class ElevationLattice {
 public:
  /// Takes positions in pixels to the study's coordinates; one that cannot be taken is not finite,
  /// and pixels beside it have no normals.
  using ToStudy = std::function<std::vector<Point>(std::vector<Point>)>;

  /// The fit must outlive it. Requires at least 1 pixel between nodes.
  ElevationLattice(const ElevationFit& fit, ToStudy to_study, std::size_t columns_apart,
                   std::size_t rows_apart, unsigned threads);

  /// The normals of a window that begins at a pixel.
  ElevationPatch over(ElevationPatch::Corner corner, std::size_t columns, std::size_t rows);

 private:
  void compute(const std::vector<ElevationPatch::Corner>& nodes);

  const ElevationFit& fit_;
  ToStudy to_study_;
  std::size_t columns_apart_;
  std::size_t rows_apart_;
  unsigned threads_;
  std::unordered_map<std::uint64_t, std::size_t> known_;  // where a node's months begin
  std::vector<ToldNormal> told_;
};

}  // namespace thiessen
