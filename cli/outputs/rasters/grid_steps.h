#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "files/netcdf_grid.h"
#include "gdal/rasters/grid_file.h"
#include "rainfall/methods/rain_surface.h"
#include "rainfall/network/reporting.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/step_length.h"
#include "rainfall/series/value_sample.h"

namespace thiessen::cli {

/// What has to be known of a series before a grid of its steps is begun.
struct GridSteps {
  std::vector<std::string> times;     ///< as RAINFALL writes them
  std::vector<WrittenTime> calendar;  ///< what they say
  ReportingStations reports;          ///< the stations that report in any step
  ValueSample sample;                 ///< of the readings
};

/// Reads all steps. Throws Error, naming `file`, where there is none.
GridSteps look_through(Readings& readings, const Network& network, const std::string& file);

/// The step that the times of the steps tell, as far as they are of the calendar.
std::optional<StepLength> step_of(const GridSteps& steps);
/// The step of all that is read.
std::optional<StepLength> step_of(Readings& readings);

/// The times of the steps by the calendar, which begin or end their steps as `stamp` says, and how
/// long these are: `step`, where that is known. Throws Error, naming `file`, where one of them is
/// no time of ISO 8601, or some have a zone and others have none.
GridTimes times_of(const GridSteps& steps, const std::optional<StepLength>& step, Stamp stamp,
                   const std::string& file, Warnings& warnings);

/// The month of a step among those that normals tell apart, else the year.
using MonthOfStep = std::function<NormalMonth(const TimeStep&)>;

/// Writes the rainfall at each pixel in each step that is read. `advance` is called after each.
/// With normals the sample of the steps becomes one of the pixels' values.
void write_steps(const Inputs& inputs, GridSteps& steps, Readings& readings, const PixelGrid& grid,
                 unsigned threads, GridFile& to, const MonthOfStep& month_of,
                 const std::function<void()>& advance);

/// Writes the values of a surface at each pixel in each step that is read, as write_steps writes
/// those of the nearest gauge. `sample` takes note of them.
void write_surfaces(const Inputs& inputs, SurfaceMethod method, Readings& readings,
                    const PixelGrid& grid, unsigned threads, GridFile& to, ValueSample& sample,
                    const MonthOfStep& month_of, const std::function<void()>& advance);

}  // namespace thiessen::cli
