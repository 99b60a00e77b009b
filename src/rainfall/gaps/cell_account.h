#pragma once

#include <cstdint>
#include <vector>

#include "tessellation/place.h"

namespace thiessen {

/// A cell's part in a basin.
struct CellWeight {
  std::uint32_t basin;
  PlaceIndex cell;
  double weight;  ///< the cell's share of the basin
};

/// What the values of one step are made of, by cell. The stations of a cell count as one gauge. It
/// depends on the gap policy whether gauges at places that rounding cannot tell apart share a cell.
struct CellAccount {
  std::vector<double> readings;  ///< by cell: the mean of its stations that report; NaN: none does
  /// The changes of the full network's weights, in any order; one weight may change in several
  /// parts. After they are added, the weights of each basin are divided by their sum. The changes
  /// in a basin without a value mean nothing.
  std::vector<CellWeight> change;
};

}  // namespace thiessen
