#include "cli/outputs/rasters/grid_steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "base/interrupt.h"
#include "base/iso_time.h"
#include "base/utf8.h"
#include "cli/outputs/rasters/raster_of.h"
#include "map/raster/area_rows.h"
#include "map/raster/step_pixels.h"
#include "map/raster/surface_rows.h"
#include "rainfall/normals/relative_readings.h"
#include "rainfall/series/step_intervals.h"

namespace thiessen::cli {
namespace {

constexpr const char* takes_any = "a .tif takes any times";

IsoTime required_time(const std::string& time, const WrittenTime& written,
                      const std::string& file) {
  if (written.parsed) return written.parsed.time;
  if (!written.fault.empty())
    throw Error({file, 0, "the time " + quoted(time, 80) + written.fault, written.hint});
  throw Error({file, 0,
               "the time " + quoted(time, 80) +
                   " is no time of the calendar as ISO 8601 writes it, and a .nc needs one",
               takes_any});
}

/// The normals of a grid's pixels, which are found when a month first comes.
class PixelNormals {
 public:
  PixelNormals(const Inputs& inputs, const PixelGrid& grid) : inputs_(inputs), grid_(grid) {}

  /// The values, one for each pixel, times the normals; valid until the next call.
  std::span<const float> times(std::span<const float> values, const NormalMonth& month) {
    const std::vector<float>& normals = of(month);
    values_.assign(values.begin(), values.end());
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] *= normals[i];
    return values_;
  }

 private:
  const std::vector<float>& of(const NormalMonth& month) {
    const auto [at, is_fresh] = by_month_.try_emplace(month);
    if (!is_fresh) return at->second;
    const auto normals = normals_in(inputs_, month);
    const PointMapping mapping = to_study(inputs_);
    for (int row = 0; row < grid_.rows; ++row) {
      throw_if_interrupted();
      for (const double normal : normals_in_row(*normals, grid_, row, mapping))
        at->second.push_back(static_cast<float>(normal));
    }
    return at->second;
  }

  const Inputs& inputs_;
  PixelGrid grid_;
  std::map<NormalMonth, std::vector<float>> by_month_;
  std::vector<float> values_;
};

}  // namespace

GridSteps look_through(Readings& readings, const Network& network, const std::string& file) {
  GridSteps steps{{}, {}, ReportingStations(network.stations().size(), false), {}};
  for (TimeStep step; readings.next(step);) {
    throw_if_interrupted();
    steps.times.push_back(step.time);
    steps.calendar.push_back(
        step.written.value_or(WrittenTime{calendar_time(step.time, {}), {}, {}}));
    for (std::uint32_t s = 0; s < step.readings.size(); ++s) {
      if (std::isnan(step.readings[s])) continue;
      steps.reports.set(StationIndex{s}, true);
      steps.sample.add(step.readings[s]);
    }
  }
  if (steps.times.empty()) throw Error({file, 0, "there is no time step to write", ""});
  return steps;
}

std::optional<StepLength> step_of(const GridSteps& steps) {
  StepIntervals intervals;
  for (const WrittenTime& time : steps.calendar) intervals.note(time.parsed);
  return intervals.step();
}

std::optional<StepLength> step_of(Readings& readings) {
  StepIntervals intervals;
  for (TimeStep step; readings.next(step);) {
    throw_if_interrupted();
    intervals.note(calendar_time(step.time, step.written));
  }
  return intervals.step();
}

GridTimes times_of(const GridSteps& steps, const std::optional<StepLength>& step, Stamp stamp,
                   const std::string& file, Warnings& warnings) {
  std::vector<IsoTime> times;
  for (std::size_t i = 0; i < steps.times.size(); ++i)
    times.push_back(required_time(steps.times[i], steps.calendar[i], file));
  const auto has_zone = [](const IsoTime& time) { return time.ahead_of_utc.has_value(); };
  const auto zoned = std::count_if(times.begin(), times.end(), has_zone);
  if (zoned != 0 && zoned != std::ssize(times)) {
    throw Error({file, 0, "some times have a zone and others have none, and a .nc counts from one",
                 takes_any});
  }
  const bool has_moments = std::any_of(times.begin(), times.end(), [](const IsoTime& time) {
    return time.precision == TimePrecision::instant;
  });
  if (!step && has_moments && times.size() == 1) {
    warnings.add_notice(
        {file, 0, "nothing tells how long its only step is: in the .nc it has no bounds", ""});
  } else if (!step && has_moments) {
    warnings.add_notice({file, 0,
                         stamp == Stamp::begin
                             ? "its times have no regular step: in the .nc each lasts until the "
                               "next, and the last as long as the one before it"
                             : "its times have no regular step: in the .nc each has lasted since "
                               "the one before it, and the first as long as the second",
                         ""});
  }
  return {bounds_of(times, step, stamp), zoned != 0, stamp};
}

void write_steps(const Inputs& inputs, GridSteps& steps, Readings& readings, const PixelGrid& grid,
                 unsigned threads, GridFile& to, const MonthOfStep& month_of,
                 const std::function<void()>& advance) {
  StepPixels pixels(
      grid, areas_of(inputs), inputs.network(), inputs.study().metric, steps.reports,
      [&] { return to_study(inputs); }, threads);
  const NormalField* const normals = inputs.weighing().normals();
  PixelNormals of_pixels(inputs, grid);
  if (normals != nullptr) steps.sample = {};
  for (TimeStep step; readings.next(step); advance()) {
    throw_if_interrupted();
    if (normals == nullptr) {
      to.add(pixels.at(step.readings));
      continue;
    }
    const NormalMonth month = month_of(step);
    const std::vector<double> relative = relative_readings(normals, step.readings, month);
    const std::span<const float> values = of_pixels.times(pixels.at(relative), month);
    for (const float value : values) steps.sample.add(value);
    to.add(values);
  }
}

void write_surfaces(const Inputs& inputs, SurfaceMethod method, Readings& readings,
                    const PixelGrid& grid, unsigned threads, GridFile& to, ValueSample& sample,
                    const MonthOfStep& month_of, const std::function<void()>& advance) {
  const std::size_t columns = static_cast<std::size_t>(grid.columns);
  const std::size_t pixels = columns * static_cast<std::size_t>(grid.rows);
  const AreaSpans spans = AreaRows(grid, areas_of(inputs)).rows(0, grid.rows);
  std::vector<std::int32_t> is_inside(pixels, 0);
  for (int row = 0; row < grid.rows; ++row) {
    const auto begin = is_inside.begin() + static_cast<std::ptrdiff_t>(row) * grid.columns;
    for (const PixelSpan& span : spans.row(row)) std::fill(begin + span.first, begin + span.end, 1);
  }
  const std::vector<float> nothing(pixels, std::numeric_limits<float>::quiet_NaN());
  for (TimeStep step; readings.next(step); advance()) {
    throw_if_interrupted();
    if (!reporting_stations(step.readings).any()) {
      to.add(nothing);
      continue;
    }
    SurfaceRows surface = surface_rows(inputs, step.readings, method, month_of(step),
                                       SurfaceRows::Beyond::nearest, grid, threads);
    const std::span<const float> values = surface.rows(0, grid.rows, is_inside);
    for (const float value : values) sample.add(value);
    to.add(values);
  }
}

}  // namespace thiessen::cli
