#pragma once

#include <string>
#include <vector>

#include "base/file.h"
#include "rainfall/network/weights.h"

namespace thiessen {

/// The unit in which the areas of weights are measured.
struct AreaUnit {
  double km2 = 1e-6;  ///< square kilometres in one unit; 1 where the plane's unit is unknown: areas
                      ///< are then written as they are

  bool known() const { return km2 != 1; }
  /// What a column of areas is called, so that nobody takes an area of unknown unit for km2.
  const char* column() const { return known() ? "area_km2" : "area"; }
};

/// A weight with the names of its basin and station.
struct WeightRow {
  std::string basin;
  std::string station;
  double area = 0;  ///< in the unit that AreaUnit::column tells
  double weight = 0;
  double factor = 1;  ///< of the year, where months have normals of their own; 1 without normals
};

/// The weights with their names, basins in file order, then stations in file order.
std::vector<WeightRow> weight_rows(const Weighing& weighing,
                                   const std::vector<BasinWeights>& weights, AreaUnit unit);

/// A station's part of a basin before and after a change of the network: 0 where it has none.
struct ChangedWeight {
  StationWeight before;
  StationWeight after;
};

/// The parts that a basin's stations have before or after, in the order of the stations.
std::vector<ChangedWeight> changed_weights(const BasinWeights& before, const BasinWeights& after);

/// Writes the table of weights: CSV `basin,station,area_km2,weight`, or with `area` where the unit
/// is unknown, in the fewest digits that read back to the same double; basins in file order, then
/// stations in file order. With normals there is a last column `factor`, by which a reading counts
/// beside its weight; where calendar months have their own there are twelve, `factor_01` to
/// `factor_12`: `weights` has those of each month (see Weighing::weights_by_month). The threads
/// make blocks of rows, which are written in their order.
void write_weights(OutputFile& file, const Weighing& weighing,
                   const std::vector<std::vector<BasinWeights>>& weights, AreaUnit unit,
                   unsigned threads = 1);

/// Writes the table of weights before and after a change of the network: CSV
/// `basin,station,area_km2,weight,area_km2_after,weight_after`, with the stations that have weight
/// before or after, in the names, digits and order of write_weights. With normals there are columns
/// `factor,factor_after` behind, or such a pair for each calendar month; a factor is empty where
/// there is no weight.
void write_changed_weights(OutputFile& file, const Weighing& weighing,
                           const std::vector<std::vector<BasinWeights>>& before,
                           const std::vector<std::vector<BasinWeights>>& after, AreaUnit unit);

}  // namespace thiessen
