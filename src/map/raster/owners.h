#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "earth/nearest/nearest_places.h"
#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"
#include "geometry/polygon.h"
#include "map/raster/area_rows.h"
#include "map/raster/block_owners.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// For each pixel of a raster the number (from 1, in file order) of the station whose place is
/// nearest to its centre: the lower number where several are equally near, 0 outside the areas and
/// where the projection ends. Accuracy: see NearestPlaces::nearest. Cost: linear in the pixels,
/// which are only filled, in those along the cells' edges, and in the areas' vertices; n log n for
/// n places.
class Owners {
 public:
  /// `areas` are in the raster's coordinates. `reports` says which stations take part; without any
  /// all pixels are 0. `to_study` makes a mapping from the raster's coordinates to the study's, for
  /// use by one thread.
  Owners(const PixelGrid& grid, const std::vector<MultiPolygon>& areas, const Network& network,
         Metric metric, const ReportingStations& reports, std::function<PointMapping()> to_study,
         unsigned threads);

  /// The numbers in `count` rows from `row` on, row by row from the north, valid until the next
  /// call. They depend neither on the number of threads nor on how many rows are asked for at once.
  /// Stops with Interrupted where a signal came.
  std::span<const std::int32_t> rows(int row, int count);

 private:
  void clear_outside(const AreaSpans& spans, int first_row, const PixelBlock& square);

  PixelGrid grid_;
  AreaRows areas_;
  std::function<PointMapping()> to_study_;
  std::vector<std::int32_t> numbers_;  ///< station number of each place
  std::unique_ptr<NearestPlaces> places_;
  std::vector<std::unique_ptr<BlockOwners>> workers_;
  std::vector<std::int32_t> rows_;
};

}  // namespace thiessen
