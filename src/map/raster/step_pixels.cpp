#include "map/raster/step_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "map/raster/owners.h"
#include "rainfall/network/mean_reading.h"

namespace thiessen {
namespace {

constexpr float outside = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t most_remembered = std::size_t{256} << 20;

PlaceRuns runs_of(const PixelGrid& grid, const std::vector<MultiPolygon>& areas,
                  const Network& network, Metric metric, const ReportingStations& reports,
                  const std::function<PointMapping()>& to_study, unsigned threads) {
  Owners owners(grid, areas, network, metric, reports, to_study, threads);
  return {grid, network, owners};
}

}  // namespace

StepPixels::StepPixels(const PixelGrid& grid, std::vector<MultiPolygon> areas,
                       const Network& network, Metric metric, const ReportingStations& reports,
                       std::function<PointMapping()> to_study, unsigned threads)
    : grid_(grid),
      areas_(std::move(areas)),
      network_(network),
      metric_(metric),
      to_study_(std::move(to_study)),
      threads_(std::max(1u, threads)),
      runs_(runs_of(grid_, areas_, network, metric, reports, to_study_, threads_)),
      handovers_(grid_, network, metric, runs_, to_study_, threads_),
      values_(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows),
              outside) {}

std::span<const float> StepPixels::at(std::span<const double> readings) {
  const std::vector<double> values = readings_by_place(network_, readings);
  ReportingPlaces reports(values.size(), true);
  std::size_t handed = 0;
  for (std::uint32_t p = 0; p < values.size(); ++p) {
    if (!std::isnan(values[p])) continue;
    reports.set(PlaceIndex{p}, false);
    handed += runs_.pixels_of(PlaceIndex{p});
  }
  if (handed > runs_.pixels() / 3) {
    fill_from_all(readings, values);
  } else {
    fill_by_runs(values, reports);
  }
  return values_;
}

void StepPixels::fill(PixelRun run, double value) {
  std::fill(values_.begin() + run.begin, values_.begin() + run.end, static_cast<float>(value));
}

void StepPixels::fill_by_runs(std::span<const double> values, const ReportingPlaces& reports) {
  handovers_.forget_beyond(most_remembered);
  constexpr std::size_t places_at_once = 64;
  const std::size_t places = values.size();
  in_parallel((places + places_at_once - 1) / places_at_once, threads_,
              [&](std::size_t worker, std::size_t block) {
                const std::size_t end = std::min(places, (block + 1) * places_at_once);
                for (std::size_t i = block * places_at_once; i < end; ++i) {
                  const PlaceIndex place{static_cast<std::uint32_t>(i)};
                  const std::span<const PixelRun> own = runs_.of(place);
                  if (own.empty()) continue;
                  if (reports[place]) {
                    for (const PixelRun run : own) fill(run, values[i]);
                    continue;
                  }
                  for (const HandedRun& handed : handovers_.of(worker, place, reports))
                    fill(handed.pixels, values[index(handed.owner)]);
                }
              });
}

void StepPixels::fill_from_all(std::span<const double> readings, std::span<const double> values) {
  constexpr int rows_at_once = 256;
  Owners owners(grid_, areas_, network_, metric_, reporting_stations(readings), to_study_,
                threads_);
  std::size_t at = 0;
  for (int row = 0; row < grid_.rows; row += rows_at_once) {
    for (const std::int32_t owner : owners.rows(row, std::min(rows_at_once, grid_.rows - row))) {
      const auto station = StationIndex{static_cast<std::uint32_t>(owner - 1)};
      values_[at++] =
          owner == 0 ? outside : static_cast<float>(values[index(network_.place_of(station))]);
    }
  }
}

}  // namespace thiessen
