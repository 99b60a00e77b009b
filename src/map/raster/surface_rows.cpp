#include "map/raster/surface_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"

namespace thiessen {
namespace {

void take_in(std::optional<ValueRange>& range, const ValueRange& more) {
  range =
      range ? ValueRange{std::min(range->least, more.least), std::max(range->largest, more.largest)}
            : more;
}

}  // namespace

SurfaceRows::SurfaceRows(const PixelGrid& grid, Beyond beyond,
                         std::function<std::unique_ptr<RainSurface>()> surface,
                         std::function<PointMapping()> to_study, unsigned threads)
    : grid_(grid),
      beyond_(beyond),
      surface_(std::move(surface)),
      to_study_(std::move(to_study)),
      workers_(std::max(1u, threads)) {}

std::span<const float> SurfaceRows::rows(int row, int count,
                                         std::span<const std::int32_t> is_inside) {
  const auto columns = static_cast<std::size_t>(grid_.columns);
  values_.assign(columns * static_cast<std::size_t>(count),
                 std::numeric_limits<float>::quiet_NaN());
  among_gauges_.assign(values_.size(), 0);
  in_parallel(static_cast<std::size_t>(count), static_cast<unsigned>(workers_.size()),
              [&](std::size_t w, std::size_t i) {
                Worker& worker = workers_[w];
                if (!worker.surface) {
                  worker.surface = surface_();
                  worker.to_study = to_study_();
                }
                const auto of_row =
                    is_inside.empty() ? is_inside : is_inside.subspan(i * columns, columns);
                fill_row(worker, row + static_cast<int>(i), of_row,
                         std::span(values_).subspan(i * columns, columns),
                         std::span(among_gauges_).subspan(i * columns, columns));
              });
  return values_;
}

void SurfaceRows::fill_row(Worker& worker, int row, std::span<const std::int32_t> is_inside,
                           std::span<float> values, std::span<std::uint8_t> among_gauges) const {
  // A row begins anew, so that its last bits do not depend on which rows a thread had before.
  worker.surface->begin_anew();
  worker.centres.clear();
  for (int column = 0; column < grid_.columns; ++column)
    worker.centres.push_back(grid_.centre(column, row));
  worker.to_study(worker.centres);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Point centre = worker.centres[i];
    if (!is_inside.empty() && is_inside[i] == 0) continue;
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) continue;
    const RainSurface::Value value =
        beyond_ == Beyond::nearest ? worker.surface->at(centre) : worker.surface->continued(centre);
    values[i] = static_cast<float>(value.rainfall);
    among_gauges[i] = value.is_among_gauges ? 1 : 0;
    if (value.is_among_gauges) take_in(worker.among_gauges, {values[i], values[i]});
  }
}

std::optional<ValueRange> SurfaceRows::range_among_gauges() const {
  std::optional<ValueRange> range;
  for (const Worker& worker : workers_) {
    if (worker.among_gauges) take_in(range, *worker.among_gauges);
  }
  return range;
}

}  // namespace thiessen
