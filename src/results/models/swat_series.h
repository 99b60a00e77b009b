#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "base/file.h"
#include "results/models/stepped_series.h"

namespace thiessen {

/// Precipitation of SWAT+: a file BASIN.pcp for each basin, with years of record, step (0: days),
/// the centroid's latitude and longitude, an elevation of 0 for it is not known, and a row
/// `year day-of-year value` a day; and pcp.cli, which lists these files. Missing values are -99.0,
/// in whose place SWAT+ makes some up.
///
/// Source: SWAT+ Input/Output Documentation, Climate, "pcp.cli and pcp data files", and SWAT+ Input
/// Reference, "*.pcp". The list is in rising order, for SWAT+ halves it to find a name.
class SwatSeries : public SteppedSeries {
 public:
  /// Gives the file of a name in the folder that is written.
  using OpenFile = std::function<OutputFile&(const std::string& name)>;

  /// Throws Error where an id cannot be a file's name in SWAT+, where two differ by case alone,
  /// where the basins' centroids are not known, and where the unit is not mm.
  SwatSeries(OpenFile open, ModelSubject subject);

  /// The names of the files that are written, pcp.cli among them.
  static std::vector<std::string> files(const std::vector<std::string>& basins);

 private:
  void write(const Steps& steps, Warnings& warnings) override;
  void write_list();
  void write_basin(const Steps& steps, std::size_t basin, std::span<const double> values);

  OpenFile open_;
};

}  // namespace thiessen
