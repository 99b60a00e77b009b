#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "basin/cell_clipper.h"
#include "diagram/surface.h"
#include "geometry/box.h"
#include "rainfall/network/network.h"
#include "rainfall/normals/raster_normals.h"

namespace thiessen::plane_raster {

/// A raster in the plane of a study: pixels of one unit, the first one's upper left corner at
/// (0, rows).
struct Raster {
  std::size_t columns;
  std::size_t rows;
  /// The value of a pixel by its left edge and its lower one, and by the month.
  std::function<double(double x, double y, std::size_t month)> value;
  std::size_t months = 1;
};

using Value = std::function<double(double x, double y, std::size_t month)>;

inline double value_at(const Value& value, Point p, std::size_t month) {
  return value(std::floor(p.x), std::floor(p.y), month);
}
inline double value_at(const Raster& raster, Point p, std::size_t month) {
  return value_at(raster.value, p, month);
}

/// The normals of a raster for a network and basins, which all have a window of the whole.
/// Those of the gauges are by `at_gauges`.
inline std::shared_ptr<const RasterNormals> normals_of(const Raster& raster, const Value& at_gauges,
                                                       const Network& network,
                                                       const std::vector<Basin>& basins) {
  std::vector<std::vector<double>> gauges;
  for (const Station& station : network.stations()) {
    std::vector<double>& months = gauges.emplace_back();
    for (std::size_t m = 0; m < raster.months; ++m)
      months.push_back(value_at(at_gauges, station.position, m));
  }
  const std::vector<double> references = gauges.front();
  std::vector<NormalWindow> windows;
  const double top = static_cast<double>(raster.rows);
  std::vector<double> areas;
  for (const Basin& basin : basins) {
    areas.push_back(area_of(basin, PlaneSurface()));
    Box box;
    for (const Polygon& part : basin.shape) {
      for (const Point p : part.outer) box.take_in(p);
    }
    WindowValues values(raster.columns, raster.rows, raster.months, true);
    for (std::size_t m = 0; m < raster.months; ++m) {
      for (std::size_t r = 0; r < raster.rows; ++r) {
        for (std::size_t c = 0; c < raster.columns; ++c) {
          values.set(m, r, c,
                     raster.value(static_cast<double>(c), top - 1 - static_cast<double>(r), m));
        }
      }
    }
    windows.push_back(
        {PixelIntegrals(std::move(values), references, std::make_unique<const EqualPixels>(1)),
         std::make_unique<const AffineMapping>(Point{0, top}, Point{1, 0}, Point{0, -1}), true,
         box.low.x >= 0 && box.low.y >= 0 && box.high.x <= static_cast<double>(raster.columns) &&
             box.high.y <= top});
  }
  return std::make_shared<const RasterNormals>(std::move(gauges), std::move(windows), basins,
                                               areas);
}

inline std::shared_ptr<const RasterNormals> normals_of(const Raster& raster, const Network& network,
                                                       const std::vector<Basin>& basins) {
  return normals_of(raster, raster.value, network, basins);
}

}  // namespace thiessen::plane_raster
