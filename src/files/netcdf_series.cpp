#include "files/netcdf_series.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/interrupt.h"
#include "rainfall/series/time_bounds.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr const char* standard_name = "thickness_of_rainfall_amount";

/// Whether CF's name for a depth of rain fits: the unit is a length that UDUNITS knows.
bool is_depth(const std::string& unit) {
  constexpr std::array<const char*, 5> depths{"mm", "cm", "m", "in", "ft"};
  return std::find(depths.begin(), depths.end(), unit) != depths.end();
}

/// Steps whose values are kept until they are written: 8 MB of them, and one at least.
std::size_t block_of(std::size_t basins) {
  constexpr std::size_t most_values = std::size_t{1} << 20;
  return std::clamp<std::size_t>(most_values / std::max<std::size_t>(1, basins), 1, 4096);
}

}  // namespace

NetcdfSeries::NetcdfSeries(const std::string& file, ModelSubject subject, std::vector<Point> plane,
                           bool has_errors)
    : subject_(std::move(subject)),
      plane_(std::move(plane)),
      times_(subject_.rainfall, "a .nc", subject_.step),
      to_(file, subject_.output),
      steps_in_block_(block_of(subject_.basins.size())),
      has_errors_(has_errors) {
  define();
}

void NetcdfSeries::define() {
  to_.put_origin(subject_.made_by);
  to_.put_text(NC_GLOBAL, "featureType", "timeSeries");
  const int basin = to_.dimension("basin", subject_.basins.size());
  time_dimension_ = to_.dimension("time", NC_UNLIMITED);
  const int id = to_.variable("basin_id", NC_STRING, std::array{basin});
  to_.put_text(id, "long_name", "the basin's id");
  to_.put_text(id, "cf_role", "timeseries_id");
  time_ = to_.variable("time", NC_DOUBLE, std::array{time_dimension_});
  // The library's own chunks along an unlimited dimension are of one step: half a gigabyte for a
  // few ten thousand.
  to_.check(nc_def_var_chunking(to_.file(), time_, NC_CHUNKED, &steps_in_block_));
  to_.check(nc_def_var_deflate(to_.file(), time_, 1, 1, 1));
  define_values(rainfall_, "rainfall", basin, time_dimension_);
  to_.put_text(rainfall_.number, "long_name", "areal rainfall");
  if (is_depth(subject_.unit)) to_.put_text(rainfall_.number, "standard_name", standard_name);
  if (has_errors_) {
    define_values(error_, "standard_error", basin, time_dimension_);
    to_.put_text(error_.number, "long_name", "standard error of the areal rainfall");
    if (is_depth(subject_.unit)) {
      to_.put_text(error_.number, "standard_name", std::string(standard_name) + " standard_error");
    }
    to_.put_text(rainfall_.number, "ancillary_variables", "standard_error");
  }
  define_places(basin);
  to_.check(nc_enddef(to_.file()));
  put_ids(id);
  put_places();
}

void NetcdfSeries::define_values(Variable& variable, const char* name, int basin, int time) {
  variable.number = to_.variable(name, NC_DOUBLE, std::array{basin, time});
  const std::array<std::size_t, 2> chunk{subject_.basins.size(), steps_in_block_};
  to_.check(nc_put_att_double(to_.file(), variable.number, "_FillValue", NC_DOUBLE, 1, &none));
  to_.put_text(variable.number, "units", subject_.unit);
  to_.check(nc_def_var_chunking(to_.file(), variable.number, NC_CHUNKED, chunk.data()));
  to_.check(nc_def_var_deflate(to_.file(), variable.number, 1, 1, 1));
}

void NetcdfSeries::define_places(int basin) {
  const bool on_earth = !subject_.centroids.empty();
  north_ = to_.variable(on_earth ? "lat" : "y", NC_DOUBLE, std::array{basin});
  east_ = to_.variable(on_earth ? "lon" : "x", NC_DOUBLE, std::array{basin});
  to_.put_text(north_, "long_name",
               on_earth ? "latitude of the basin's centroid" : "y of the basin's centroid");
  to_.put_text(east_, "long_name",
               on_earth ? "longitude of the basin's centroid" : "x of the basin's centroid");
  if (on_earth) {
    to_.put_text(north_, "standard_name", "latitude");
    to_.put_text(north_, "units", "degrees_north");
    to_.put_text(east_, "standard_name", "longitude");
    to_.put_text(east_, "units", "degrees_east");
  }
  const std::string coordinates = on_earth ? "basin_id lat lon" : "basin_id y x";
  to_.put_text(rainfall_.number, "coordinates", coordinates);
  if (has_errors_) to_.put_text(error_.number, "coordinates", coordinates);
}

void NetcdfSeries::put_places() {
  const std::vector<Point>& points = subject_.centroids.empty() ? plane_ : subject_.centroids;
  std::vector<double> norths;
  std::vector<double> easts;
  for (const Point& point : points) {
    norths.push_back(point.y);
    easts.push_back(point.x);
  }
  to_.check(nc_put_var_double(to_.file(), north_, norths.data()));
  to_.check(nc_put_var_double(to_.file(), east_, easts.data()));
}

void NetcdfSeries::put_ids(int variable) {
  std::vector<const char*> ids;
  for (const std::string& id : subject_.basins) ids.push_back(id.c_str());
  to_.check(nc_put_var_string(to_.file(), variable, ids.data()));
}

void NetcdfSeries::add(const IsoTime& time, std::span<const double> rainfall,
                       std::span<const double> errors) {
  throw_if_interrupted();
  times_.note(time);
  moments_.push_back(time);
  rainfall_.block.insert(rainfall_.block.end(), rainfall.begin(), rainfall.end());
  if (has_errors_) error_.block.insert(error_.block.end(), errors.begin(), errors.end());
  if (moments_.size() - written_ == steps_in_block_) put_block();
}

void NetcdfSeries::put_block() {
  if (moments_.size() == written_) return;
  put_block(rainfall_);
  if (has_errors_) put_block(error_);
  written_ = moments_.size();
  rainfall_.block.clear();
  error_.block.clear();
}

void NetcdfSeries::put_block(const Variable& variable) const {
  const std::size_t basins = subject_.basins.size();
  const std::size_t steps = moments_.size() - written_;
  std::vector<double> turned(basins * steps);
  for (std::size_t step = 0; step < steps; ++step) {
    for (std::size_t b = 0; b < basins; ++b)
      turned[b * steps + step] = variable.block[step * basins + b];
  }
  const std::array<std::size_t, 2> first{0, written_};
  const std::array<std::size_t, 2> count{basins, steps};
  to_.check(
      nc_put_vara_double(to_.file(), variable.number, first.data(), count.data(), turned.data()));
}

void NetcdfSeries::finish(Warnings& warnings) {
  if (moments_.empty()) throw Error({subject_.rainfall, 0, "there is no time step to write", ""});
  put_block();
  put_times(warnings);
  to_.close();
}

void NetcdfSeries::put_times(Warnings& warnings) {
  const std::optional<StepLength> step = times_.step();
  const std::vector<TimeBounds> bounds = bounds_of(moments_, step, subject_.stamp);
  const bool have_lengths = std::all_of(bounds.begin(), bounds.end(),
                                        [](const TimeBounds& one) { return one.end > one.begin; });
  const bool ends = subject_.stamp == Stamp::end;
  to_.check(nc_redef(to_.file()));
  to_.put_text(time_, "standard_name", "time");
  to_.put_text(time_, "axis", "T");
  to_.put_text(time_, "units",
               std::string("seconds since 1970-01-01 00:00:00") + (times_.zone() ? " +00:00" : ""));
  to_.put_text(time_, "calendar", "proleptic_gregorian");
  to_.put_text(
      time_, "comment",
      ends ? "a time with a clock is when its step ends" : "a time is when its step begins");
  int time_bounds = -1;
  if (have_lengths) {
    const int two = to_.dimension("nv", 2);
    to_.put_text(time_, "bounds", "time_bnds");
    time_bounds = to_.variable("time_bnds", NC_DOUBLE, std::array{time_dimension_, two});
    const std::array<std::size_t, 2> chunk{steps_in_block_, 2};
    to_.check(nc_def_var_chunking(to_.file(), time_bounds, NC_CHUNKED, chunk.data()));
    to_.check(nc_def_var_deflate(to_.file(), time_bounds, 1, 1, 1));
    to_.put_text(rainfall_.number, "cell_methods",
                 std::string("area: mean ") + time_method_of(subject_.unit));
  }
  to_.check(nc_enddef(to_.file()));
  std::vector<double> stamps;
  std::vector<double> both;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const bool is_end = ends && moments_[i].precision == TimePrecision::instant;
    stamps.push_back(is_end ? bounds[i].end : bounds[i].begin);
    both.insert(both.end(), {bounds[i].begin, bounds[i].end});
  }
  const std::array<std::size_t, 2> first{0, 0};
  const std::array<std::size_t, 2> count{stamps.size(), 2};
  to_.check(nc_put_vara_double(to_.file(), time_, first.data(), count.data(), stamps.data()));
  if (have_lengths) {
    to_.check(nc_put_vara_double(to_.file(), time_bounds, first.data(), count.data(), both.data()));
  }
  if (!have_lengths || step || moments_.front().precision != TimePrecision::instant) {
    if (!have_lengths)
      warnings.add_notice({subject_.rainfall, 0,
                           "nothing tells how long its only step is: in the .nc it has no bounds",
                           ""});
    return;
  }
  warnings.add_notice({subject_.rainfall, 0,
                       ends ? "its times have no regular step: in the .nc each has lasted since "
                              "the one before it, and the first as long as the second"
                            : "its times have no regular step: in the .nc each lasts until the "
                              "next, and the last as long as the one before it",
                       ""});
}

}  // namespace thiessen
