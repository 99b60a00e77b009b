#include "files/netcdf_grid.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <limits>

#include "base/error.h"
#include "base/interrupt.h"
#include "gdal/crs/grid_mapping.h"

namespace thiessen {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();

/// A chunk is compressed on its own: whole rows of one step, of 4 MB at most.
std::array<std::size_t, 3> chunk_of(const PixelGrid& grid) {
  constexpr std::size_t most_pixels = std::size_t{1} << 20;
  const auto columns = static_cast<std::size_t>(grid.columns);
  const auto rows = static_cast<std::size_t>(grid.rows);
  return {1, std::clamp<std::size_t>(most_pixels / columns, 1, rows), columns};
}

/// Whether all steps have a length.
bool have_lengths(const GridTimes& times) {
  return std::all_of(times.bounds.begin(), times.bounds.end(),
                     [](const TimeBounds& step) { return step.end > step.begin; });
}

}  // namespace

NetcdfGrid::NetcdfGrid(const std::string& file, const RasterOutput& output, const GridTimes& times)
    : output_(output) {
  if (output.compression == Compression::zstd) {
    throw Error(Message{output.path, 0, "few programs read a NetCDF that is compressed by ZSTD",
                        setting("compress", "deflate") + " is read by all"});
  }
  to_.emplace(file, output.path);
  define(times);
}

void NetcdfGrid::define(const GridTimes& times) {
  to_->put_origin(output_.made_by);
  const bool is_geographic = output_.crs && output_.crs->geographic();
  const int time = to_->dimension("time", NC_UNLIMITED);
  const PixelGrid& grid = output_.grid;
  const int south =
      define_axis(is_geographic ? "lat" : "y", static_cast<std::size_t>(grid.rows), false);
  const int east =
      define_axis(is_geographic ? "lon" : "x", static_cast<std::size_t>(grid.columns), true);
  define_times(time, times);
  if (output_.crs) define_mapping();
  define_rainfall(time, south, east, have_lengths(times));
  to_->check(nc_enddef(to_->file()));
  put_times(times);
}

int NetcdfGrid::define_axis(const char* name, std::size_t length, bool is_east) {
  const int dimension = to_->dimension(name, length);
  const int axis = to_->variable(name, NC_DOUBLE, std::array{dimension});
  to_->put_text(axis, "axis", is_east ? "X" : "Y");
  if (output_.crs && output_.crs->geographic()) {
    to_->put_text(axis, "standard_name", is_east ? "longitude" : "latitude");
    to_->put_text(axis, "units", is_east ? "degrees_east" : "degrees_north");
  } else if (output_.crs) {
    to_->put_text(axis, "standard_name",
                  is_east ? "projection_x_coordinate" : "projection_y_coordinate");
    to_->put_text(axis, "units", grid_mapping(*output_.crs).unit);
  }
  put_centres(axis, is_east);
  return dimension;
}

void NetcdfGrid::put_centres(int axis, bool is_east) {
  const PixelGrid& grid = output_.grid;
  const int count = is_east ? grid.columns : grid.rows;
  std::vector<double> centres;
  centres.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    centres.push_back(is_east ? grid.centre(i, 0).x : grid.centre(0, i).y);
  to_->check(nc_put_var_double(to_->file(), axis, centres.data()));
}

void NetcdfGrid::define_mapping() {
  const int crs = to_->variable("crs", NC_INT, {});
  const GridMapping mapping = grid_mapping(*output_.crs);
  for (const auto& [name, text] : mapping.texts) to_->put_text(crs, name.c_str(), text);
  for (const auto& [name, numbers] : mapping.numbers)
    to_->check(nc_put_att_double(to_->file(), crs, name.c_str(), NC_DOUBLE, numbers.size(),
                                 numbers.data()));
}

void NetcdfGrid::define_rainfall(int time, int south, int east, bool has_bounds) {
  rainfall_ = to_->variable("rainfall", NC_FLOAT, std::array{time, south, east});
  to_->check(nc_put_att_float(to_->file(), rainfall_, "_FillValue", NC_FLOAT, 1, &none));
  to_->put_text(rainfall_, "long_name", "rainfall");
  to_->put_text(rainfall_, "units", output_.made_by.unit);
  if (has_bounds) to_->put_text(rainfall_, "cell_methods", time_method_of(output_.made_by.unit));
  if (output_.crs) to_->put_text(rainfall_, "grid_mapping", "crs");
  to_->check(
      nc_def_var_chunking(to_->file(), rainfall_, NC_CHUNKED, chunk_of(output_.grid).data()));
  if (output_.compression == Compression::deflate)
    to_->check(nc_def_var_deflate(to_->file(), rainfall_, 0, 1, 1));
}

void NetcdfGrid::define_times(int time, const GridTimes& times) {
  time_ = to_->variable("time", NC_DOUBLE, std::array{time});
  to_->put_text(time_, "standard_name", "time");
  to_->put_text(time_, "axis", "T");
  to_->put_text(time_, "units",
                std::string("seconds since 1970-01-01 00:00:00") + (times.is_utc ? " +00:00" : ""));
  to_->put_text(time_, "calendar", "proleptic_gregorian");
  to_->put_text(time_, "comment",
                times.stamp == Stamp::begin ? "a time is when its step begins"
                                            : "a time with a clock is when its step ends");
  if (!have_lengths(times)) return;
  const int ends = to_->dimension("nv", 2);
  to_->put_text(time_, "bounds", "time_bnds");
  time_bounds_ = to_->variable("time_bnds", NC_DOUBLE, std::array{time, ends});
}

void NetcdfGrid::put_times(const GridTimes& times) {
  std::vector<double> stamps;
  std::vector<double> bounds;
  for (const TimeBounds& step : times.bounds) {
    stamps.push_back(times.stamp == Stamp::begin ? step.begin : step.end);
    bounds.insert(bounds.end(), {step.begin, step.end});
  }
  const std::array<std::size_t, 2> first{0, 0};
  const std::array<std::size_t, 2> count{stamps.size(), 2};
  to_->check(nc_put_vara_double(to_->file(), time_, first.data(), count.data(), stamps.data()));
  if (time_bounds_ >= 0)
    to_->check(
        nc_put_vara_double(to_->file(), time_bounds_, first.data(), count.data(), bounds.data()));
}

void NetcdfGrid::add(std::span<const float> pixels) {
  throw_if_interrupted();
  const std::array<std::size_t, 3> first{steps_++, 0, 0};
  const std::array<std::size_t, 3> count{1, static_cast<std::size_t>(output_.grid.rows),
                                         static_cast<std::size_t>(output_.grid.columns)};
  to_->check(nc_put_vara_float(to_->file(), rainfall_, first.data(), count.data(), pixels.data()));
}

void NetcdfGrid::close() {
  to_->close();
}

}  // namespace thiessen
