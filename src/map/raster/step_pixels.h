#pragma once

#include <functional>
#include <span>
#include <vector>

#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"
#include "geometry/polygon.h"
#include "map/raster/pixel_handovers.h"
#include "map/raster/place_runs.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// The rainfall at each pixel of a raster, time step after time step: that of the nearest place at
/// which a gauge reports, in the tessellation of those that do. NaN outside the areas, and
/// everywhere where none reports.
///
/// The owners of the pixels are found once, with all gauges reporting; in a step only the pixels of
/// silent places are given to others (see PixelHandovers). Where silent places own more than a
/// third of the pixels, all of them are found anew. Cost of a step: its runs of pixels, and what
/// its gaps change. Memory: 4 bytes a pixel, 8 a run, and up to 256 MB of handovers.
class StepPixels {
 public:
  /// `reports` says which stations report in any step. `areas` are in the raster's coordinates;
  /// `to_study` makes a mapping from these to the study's, for use by one thread. The network must
  /// outlive this object.
  StepPixels(const PixelGrid& grid, std::vector<MultiPolygon> areas, const Network& network,
             Metric metric, const ReportingStations& reports,
             std::function<PointMapping()> to_study, unsigned threads);

  /// The values of a step, row by row from the north, valid until the next call. `readings` has one
  /// entry for each station, NaN where it is silent. They do not depend on the number of threads.
  std::span<const float> at(std::span<const double> readings);

 private:
  void fill_from_all(std::span<const double> readings, std::span<const double> values);
  void fill_by_runs(std::span<const double> values, const ReportingPlaces& reports);
  void fill(PixelRun run, double value);

  PixelGrid grid_;
  std::vector<MultiPolygon> areas_;
  const Network& network_;
  Metric metric_;
  std::function<PointMapping()> to_study_;
  unsigned threads_;
  PlaceRuns runs_;
  PixelHandovers handovers_;
  std::vector<float> values_;
};

}  // namespace thiessen
