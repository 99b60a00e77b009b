#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"
#include "rainfall/methods/rain_surface.h"

namespace thiessen {

/// The values of a surface at the centres of a raster's pixels.
class SurfaceRows {
 public:
  /// What of the surface is shown: all of it, or what lies among the gauges.
  enum class Extent : std::uint8_t { all, among_gauges };

  /// `surface` and `to_study` make one for a thread; the latter maps the raster's coordinates to
  /// the study's.
  SurfaceRows(const PixelGrid& grid, Extent extent,
              std::function<std::unique_ptr<RainSurface>()> surface,
              std::function<PointMapping()> to_study, unsigned threads);

  /// The values in `count` rows from `row` on, row by row from the north, valid until the next
  /// call. NaN beyond the extent, where the projection ends, and where `is_inside`, one entry for
  /// each of the pixels, is 0; if that is empty all pixels are wanted. Stops with Interrupted where
  /// a signal came.
  std::span<const float> rows(int row, int count, std::span<const std::int32_t> is_inside);

 private:
  struct Worker {
    std::unique_ptr<RainSurface> surface;
    PointMapping to_study;
    std::vector<Point> centres;
  };
  void fill_row(Worker& worker, int row, std::span<const std::int32_t> is_inside,
                std::span<float> values) const;

  PixelGrid grid_;
  Extent extent_;
  std::function<std::unique_ptr<RainSurface>()> surface_;
  std::function<PointMapping()> to_study_;
  std::vector<Worker> workers_;
  std::vector<float> values_;
};

}  // namespace thiessen
