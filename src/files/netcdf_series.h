#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/iso_time.h"
#include "files/netcdf_writer.h"
#include "results/models/model_series.h"
#include "results/models/series_times.h"

namespace thiessen {

/// Series of areal rainfall as NetCDF-4 by CF-1.8's discrete sampling geometries: featureType
/// timeSeries, in the orthogonal multidimensional array representation. `rainfall(basin, time)`,
/// `basin_id(basin)` with the role timeseries_id, `lat` and `lon` of the basins' centroids, or `x`
/// and `y` in a plane that has no CRS; `standard_error(basin, time)` as an ancillary variable where
/// errors were asked for; `time` in the order of the readings, with its bounds where all steps have
/// a length. Values are doubles, so that no digit is lost.
///
/// Source: CF Metadata Conventions 1.8, chapter 9 and appendix H, "Time Series Data".
///
/// Steps are on their way to the disk in blocks of 8 MB at most; memory grows with 40 bytes a step
/// for its time, which bounds need.
class NetcdfSeries : public ModelSeries {
 public:
  /// Begins the file. `file` is where it is written. `plane` has the basins' centroids where these
  /// are not known on the Earth.
  NetcdfSeries(const std::string& file, ModelSubject subject, std::vector<Point> plane,
               bool has_errors);

  void add(const IsoTime& time, std::span<const double> rainfall,
           std::span<const double> errors) override;
  void finish(Warnings& warnings) override;

 private:
  struct Variable {
    int number = -1;
    std::vector<double> block;  ///< by step, then by basin
  };

  void define();
  void define_places(int basin);
  void define_values(Variable& variable, const char* name, int basin, int time);
  void put_ids(int variable);
  void put_places();
  void put_block();
  void put_block(const Variable& variable) const;
  void put_times(Warnings& warnings);

  ModelSubject subject_;
  std::vector<Point> plane_;
  SeriesTimes times_;
  NetcdfWriter to_;
  std::size_t steps_in_block_;
  Variable rainfall_;
  Variable error_;
  bool has_errors_;
  int time_dimension_ = -1;
  int time_ = -1;
  int north_ = -1;
  int east_ = -1;
  std::size_t written_ = 0;  ///< steps that are in the file
  std::vector<IsoTime> moments_;
};

}  // namespace thiessen
