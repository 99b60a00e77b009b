#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"
#include "rainfall/methods/isohyets.h"
#include "rainfall/methods/rain_surface.h"

namespace thiessen {

/// The values of a surface at the centres of a raster's pixels.
class SurfaceRows {
 public:
  /// What stands beyond the gauges' hull: the nearest gauge's value, or how the surface goes on,
  /// for lines that end on the hull.
  enum class Beyond : std::uint8_t { nearest, continued };

  /// `surface` and `to_study` make one for a thread; the latter maps the raster's coordinates to
  /// the study's.
  SurfaceRows(const PixelGrid& grid, Beyond beyond,
              std::function<std::unique_ptr<RainSurface>()> surface,
              std::function<PointMapping()> to_study, unsigned threads);

  /// The values in `count` rows from `row` on, row by row from the north, valid until the next
  /// call. NaN where the projection ends, and where `is_inside`, one entry for each of the pixels,
  /// is 0; if that is empty all pixels are wanted. Stops with Interrupted where a signal came.
  std::span<const float> rows(int row, int count, std::span<const std::int32_t> is_inside);
  /// For each of the pixels that `rows` was last asked for whether it lies among the gauges; 0
  /// where it has no value.
  std::span<const std::uint8_t> are_among_gauges() const { return among_gauges_; }
  /// The least and the largest value that was asked for among the gauges; nothing where there was
  /// none.
  std::optional<ValueRange> range_among_gauges() const;

 private:
  struct Worker {
    std::unique_ptr<RainSurface> surface;
    PointMapping to_study;
    std::vector<Point> centres;
    std::optional<ValueRange> among_gauges;
  };
  void fill_row(Worker& worker, int row, std::span<const std::int32_t> is_inside,
                std::span<float> values, std::span<std::uint8_t> among_gauges) const;

  PixelGrid grid_;
  Beyond beyond_;
  std::function<std::unique_ptr<RainSurface>()> surface_;
  std::function<PointMapping()> to_study_;
  std::vector<Worker> workers_;
  std::vector<float> values_;
  std::vector<std::uint8_t> among_gauges_;
};

}  // namespace thiessen
