#include "files/netcdf_grid.h"

#include <H5public.h>
#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/interrupt.h"
#include "gdal/crs/grid_mapping.h"

namespace thiessen {
namespace {

constexpr float none = std::numeric_limits<float>::quiet_NaN();
constexpr int whole_file = NC_GLOBAL;

/// A chunk is compressed on its own: whole rows of one step, of 4 MB at most.
std::array<std::size_t, 3> chunk_of(const PixelGrid& grid) {
  constexpr std::size_t most_pixels = std::size_t{1} << 20;
  const auto columns = static_cast<std::size_t>(grid.columns);
  const auto rows = static_cast<std::size_t>(grid.rows);
  return {1, std::clamp<std::size_t>(most_pixels / columns, 1, rows), columns};
}

/// Whether the system gives this reason for a failed write. The library has one for all of them.
bool is_of_disk(int why) {
  return why == ENOSPC || why == EFBIG || why == EDQUOT || why == EIO;
}

/// Whether all steps have a length.
bool have_lengths(const GridTimes& times) {
  return std::all_of(times.bounds.begin(), times.bounds.end(),
                     [](const TimeBounds& step) { return step.end > step.begin; });
}

/// What the rainfall of a step is of its time: a sum, but of a rate such as mm/h a mean.
const char* method_of(const std::string& unit) {
  const bool is_rate = unit.find('/') != std::string::npos ||
                       unit.find(" per ") != std::string::npos ||
                       unit.find("-1") != std::string::npos;
  return is_rate ? "time: mean" : "time: sum";
}

}  // namespace

NetcdfGrid::NetcdfGrid(const std::string& file, const RasterOutput& output, const GridTimes& times)
    : output_(output) {
  if (output.compression == Compression::zstd) {
    throw Error(Message{output.path, 0, "few programs read a NetCDF that is compressed by ZSTD",
                        setting("compress", "deflate") + " is read by all"});
  }
  // Where the disk was full, HDF5 would crash as the program ends: it tries to close the file
  // again.
  H5dont_atexit();
  check(nc_create(file.c_str(), NC_NETCDF4 | NC_NOCLOBBER, &file_));
  define(times);
}

NetcdfGrid::~NetcdfGrid() {
  if (file_ >= 0) nc_close(file_);
}

void NetcdfGrid::check(int status) const {
  if (status == NC_NOERR) return;
  const int why = errno;
  throw Error(Message{output_.path, 0,
                      std::string("cannot be written: ") +
                          (is_of_disk(why) ? std::strerror(why) : nc_strerror(status)),
                      ""});
}

int NetcdfGrid::variable(const char* name, int type, std::span<const int> dimensions) {
  int made = -1;
  check(
      nc_def_var(file_, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &made));
  return made;
}

void NetcdfGrid::put_text(int variable, const char* name, const std::string& text) {
  check(nc_put_att_text(file_, variable, name, text.size(), text.data()));
}

void NetcdfGrid::define(const GridTimes& times) {
  put_text(whole_file, "Conventions", "CF-1.8");
  put_text(whole_file, "source", output_.made_by.software);
  for (const auto& [name, value] : items_of(output_.made_by))
    put_text(whole_file, name.c_str(), value);
  const bool is_geographic = output_.crs && output_.crs->geographic();
  int time = -1;
  check(nc_def_dim(file_, "time", NC_UNLIMITED, &time));
  const PixelGrid& grid = output_.grid;
  const int south =
      define_axis(is_geographic ? "lat" : "y", static_cast<std::size_t>(grid.rows), false);
  const int east =
      define_axis(is_geographic ? "lon" : "x", static_cast<std::size_t>(grid.columns), true);
  define_times(time, times);
  if (output_.crs) define_mapping();
  define_rainfall(time, south, east, have_lengths(times));
  check(nc_enddef(file_));
  put_times(times);
}

int NetcdfGrid::define_axis(const char* name, std::size_t length, bool is_east) {
  int dimension = -1;
  check(nc_def_dim(file_, name, length, &dimension));
  const int axis = variable(name, NC_DOUBLE, std::array{dimension});
  put_text(axis, "axis", is_east ? "X" : "Y");
  if (output_.crs && output_.crs->geographic()) {
    put_text(axis, "standard_name", is_east ? "longitude" : "latitude");
    put_text(axis, "units", is_east ? "degrees_east" : "degrees_north");
  } else if (output_.crs) {
    put_text(axis, "standard_name",
             is_east ? "projection_x_coordinate" : "projection_y_coordinate");
    put_text(axis, "units", grid_mapping(*output_.crs).unit);
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
  check(nc_put_var_double(file_, axis, centres.data()));
}

void NetcdfGrid::define_mapping() {
  const int crs = variable("crs", NC_INT, {});
  const GridMapping mapping = grid_mapping(*output_.crs);
  for (const auto& [name, text] : mapping.texts) put_text(crs, name.c_str(), text);
  for (const auto& [name, numbers] : mapping.numbers)
    check(nc_put_att_double(file_, crs, name.c_str(), NC_DOUBLE, numbers.size(), numbers.data()));
}

void NetcdfGrid::define_rainfall(int time, int south, int east, bool has_bounds) {
  rainfall_ = variable("rainfall", NC_FLOAT, std::array{time, south, east});
  check(nc_put_att_float(file_, rainfall_, "_FillValue", NC_FLOAT, 1, &none));
  put_text(rainfall_, "long_name", "rainfall");
  put_text(rainfall_, "units", output_.made_by.unit);
  if (has_bounds) put_text(rainfall_, "cell_methods", method_of(output_.made_by.unit));
  if (output_.crs) put_text(rainfall_, "grid_mapping", "crs");
  check(nc_def_var_chunking(file_, rainfall_, NC_CHUNKED, chunk_of(output_.grid).data()));
  if (output_.compression == Compression::deflate)
    check(nc_def_var_deflate(file_, rainfall_, 0, 1, 1));
}

void NetcdfGrid::define_times(int time, const GridTimes& times) {
  time_ = variable("time", NC_DOUBLE, std::array{time});
  put_text(time_, "standard_name", "time");
  put_text(time_, "axis", "T");
  put_text(time_, "units",
           std::string("seconds since 1970-01-01 00:00:00") + (times.is_utc ? " +00:00" : ""));
  put_text(time_, "calendar", "proleptic_gregorian");
  put_text(time_, "comment",
           times.stamp == Stamp::begin ? "a time is when its step begins"
                                       : "a time with a clock is when its step ends");
  if (!have_lengths(times)) return;
  int ends = -1;
  check(nc_def_dim(file_, "nv", 2, &ends));
  put_text(time_, "bounds", "time_bnds");
  time_bounds_ = variable("time_bnds", NC_DOUBLE, std::array{time, ends});
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
  check(nc_put_vara_double(file_, time_, first.data(), count.data(), stamps.data()));
  if (time_bounds_ >= 0)
    check(nc_put_vara_double(file_, time_bounds_, first.data(), count.data(), bounds.data()));
}

void NetcdfGrid::add(std::span<const float> pixels) {
  throw_if_interrupted();
  const std::array<std::size_t, 3> first{steps_++, 0, 0};
  const std::array<std::size_t, 3> count{1, static_cast<std::size_t>(output_.grid.rows),
                                         static_cast<std::size_t>(output_.grid.columns)};
  check(nc_put_vara_float(file_, rainfall_, first.data(), count.data(), pixels.data()));
}

void NetcdfGrid::close() {
  const int file = file_;
  file_ = -1;
  check(nc_close(file));
}

}  // namespace thiessen
