#include "cli/outputs/grid_steps.h"

#include <algorithm>
#include <cmath>

#include "base/interrupt.h"
#include "base/iso_time.h"
#include "base/utf8.h"
#include "cli/outputs/raster_of.h"
#include "map/raster/step_pixels.h"
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

}  // namespace

GridSteps look_through(Readings& readings, const Network& network, const std::string& file) {
  GridSteps steps{{}, {}, ReportingStations(network.stations().size(), false)};
  for (TimeStep step; readings.next(step);) {
    throw_if_interrupted();
    steps.times.push_back(step.time);
    steps.calendar.push_back(
        step.written.value_or(WrittenTime{calendar_time(step.time, {}), {}, {}}));
    for (std::uint32_t s = 0; s < step.readings.size(); ++s) {
      if (!std::isnan(step.readings[s])) steps.reports.set(StationIndex{s}, true);
    }
  }
  if (steps.times.empty()) throw Error({file, 0, "there is no time step to write", ""});
  return steps;
}

GridTimes times_of(const GridSteps& steps, Stamp stamp, const std::string& file,
                   Warnings& warnings) {
  std::vector<IsoTime> times;
  StepIntervals intervals;
  for (std::size_t i = 0; i < steps.times.size(); ++i) {
    times.push_back(required_time(steps.times[i], steps.calendar[i], file));
    intervals.note({times.back(), IsoTimeFault::none});
  }
  const auto has_zone = [](const IsoTime& time) { return time.ahead_of_utc.has_value(); };
  const auto zoned = std::count_if(times.begin(), times.end(), has_zone);
  if (zoned != 0 && zoned != std::ssize(times)) {
    throw Error({file, 0, "some times have a zone and others have none, and a .nc counts from one",
                 takes_any});
  }
  const std::optional<StepLength> step = intervals.step();
  const bool has_moments = std::any_of(times.begin(), times.end(), [](const IsoTime& time) {
    return time.precision == TimePrecision::instant;
  });
  if (!step && has_moments) {
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

void write_steps(const Inputs& inputs, const GridSteps& steps, Readings& readings,
                 const PixelGrid& grid, unsigned threads, GridFile& to,
                 const std::function<void()>& advance) {
  StepPixels pixels(
      grid, areas_of(inputs), inputs.network(), inputs.study().metric, steps.reports,
      [&] { return to_study(inputs); }, threads);
  for (TimeStep step; readings.next(step); advance()) {
    throw_if_interrupted();
    to.add(pixels.at(step.readings));
  }
}

}  // namespace thiessen::cli
