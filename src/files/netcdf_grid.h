#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/netcdf_writer.h"
#include "gdal/rasters/grid_file.h"
#include "gdal/rasters/raster_output.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/time_bounds.h"

namespace thiessen {

/// The times of a grid's steps, in their order.
struct GridTimes {
  std::vector<TimeBounds> bounds;
  bool is_utc = false;         ///< whether they are counted in UTC, because a zone is written
  Stamp stamp = Stamp::begin;  ///< which of its bounds is the time of a step
};

/// A grid as NetCDF-4 by the conventions CF-1.8: `rainfall(time, y, x)`, or (time, lat, lon) in a
/// geographic CRS, `time` with its bounds where all steps have a length, over which rainfall is a
/// sum (or, where its unit is that of a rate, a mean), and the grid mapping `crs` where the CRS is
/// known. A
/// step is on its way to the disk when `add` returns, so memory does not grow with the steps.
class NetcdfGrid : public GridFile {
 public:
  /// Begins the file. `file` is where it is written, `output.path` its name in messages. `output`
  /// must outlive the grid. Throws Error where the compression is ZSTD.
  NetcdfGrid(const std::string& file, const RasterOutput& output, const GridTimes& times);
  NetcdfGrid(const NetcdfGrid&) = delete;
  NetcdfGrid& operator=(const NetcdfGrid&) = delete;

  void add(std::span<const float> pixels) override;
  /// Ends the file.
  void close();

 private:
  void define(const GridTimes& times);
  int define_axis(const char* name, std::size_t length, bool is_east);
  void define_mapping();
  void define_rainfall(int time, int south, int east, bool has_bounds);
  void define_times(int time, const GridTimes& times);
  void put_centres(int variable, bool is_east);
  void put_times(const GridTimes& times);

  const RasterOutput& output_;
  std::optional<NetcdfWriter> to_;
  int rainfall_ = -1;
  int time_ = -1;
  int time_bounds_ = -1;  ///< -1: there are none
  std::size_t steps_ = 0;
};

}  // namespace thiessen
