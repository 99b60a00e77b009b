#pragma once

#include <cstdint>
#include <vector>

#include "tessellation/place.h"

namespace thiessen {

/// A cell's part in a basin.
struct CellWeight {
  std::uint32_t basin;
  PlaceIndex cell;
  double weight;  ///< its share of the basin
};

/// What the values of one step are made of, by cell. A cell's stations count as one gauge. Whether
/// gauges at places that rounding cannot tell apart share a cell is the gap policy's to say.
struct CellAccount {
  std::vector<double> readings;  ///< by cell, the mean of its stations that report; NaN: none does
  /// What is added to the full network's weights, in any order and perhaps in several parts; then
  /// all of a basin are divided by their sum. Where a basin has no value its part says nothing.
  std::vector<CellWeight> change;
};

}  // namespace thiessen
