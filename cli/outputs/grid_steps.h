#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/inputs/inputs.h"
#include "files/netcdf_grid.h"
#include "gdal/output/grid_file.h"
#include "rainfall/network/reporting.h"
#include "rainfall/series/readings.h"

namespace thiessen::cli {

/// What has to be known of a series before a grid of its steps is begun.
struct GridSteps {
  std::vector<std::string> times;     ///< as RAINFALL writes them
  std::vector<WrittenTime> calendar;  ///< what they say
  ReportingStations reports;          ///< the stations that report in any step
};

/// Reads all steps. Throws Error, naming `file`, where there is none.
GridSteps look_through(Readings& readings, const Network& network, const std::string& file);

/// The times of the steps by the calendar, which begin or end their steps as `stamp` says. Throws
/// Error, naming `file`, where one of them is no time of ISO 8601, or some have a zone and others
/// have none.
GridTimes times_of(const GridSteps& steps, Stamp stamp, const std::string& file,
                   Warnings& warnings);

/// Writes the rainfall at each pixel in each step that is read. `advance` is called after each.
void write_steps(const Inputs& inputs, const GridSteps& steps, Readings& readings,
                 const PixelGrid& grid, unsigned threads, GridFile& to,
                 const std::function<void()>& advance);

}  // namespace thiessen::cli
