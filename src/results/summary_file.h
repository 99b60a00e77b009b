#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/file.h"
#include "results/weights_file.h"

namespace thiessen {

/// The largest depth of a basin in a length of time, and when that begins.
struct BasinDepth {
  std::string length;           ///< such as 24h
  std::optional<double> depth;  ///< nothing where no such time is known from end to end
  std::string time;
};

/// What a series of areal rainfall comes to in one basin.
struct BasinSummary {
  std::string basin;
  double area = 0;  ///< in the unit of the column of areas
  std::size_t gauges_inside = 0;
  std::size_t gauges_weighing = 0;
  double largest_weight = 0;
  /// The mean rainfall of the steps that have a value, in the unit of the readings; nothing where
  /// no step has one.
  std::optional<double> mean;
  std::optional<double> standard_error;  ///< of the mean; nothing where it cannot be had
  std::optional<double> largest;
  std::vector<BasinDepth> depths;  ///< the same lengths in every basin
  std::size_t empty_steps = 0;     ///< how many have no value
  /// The station without which the values change most, by root mean square; empty where none is
  /// known.
  std::string most_influential;
  double influence = 0;  ///< that root mean square
};

/// Writes the summary as CSV `basin,area_km2,gauges_inside,gauges_weighing,largest_weight,mean,
/// standard_error,largest,empty_steps,most_influential,influence`, or with `area` where the unit is
/// unknown, and behind them max_LENGTH and max_LENGTH_time of each length of time: a row a basin,
/// numbers in the fewest digits that read back to the same double, and nothing where there is no
/// value.
void write_summary(OutputFile& file, std::span<const BasinSummary> basins, AreaUnit unit);

}  // namespace thiessen
