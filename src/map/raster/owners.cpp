#include "map/raster/owners.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"

namespace thiessen {
namespace {

/// Parts some rows of the raster into squares. The last square of each row of squares may be
/// narrower, and the last row of squares lower.
std::vector<PixelBlock> squares_of(int columns, int row, int rows) {
  constexpr int side = 128;
  std::vector<PixelBlock> squares;
  for (int south = 0; south < rows; south += side) {
    for (int column = 0; column < columns; column += side) {
      squares.push_back(
          {column, row + south, std::min(side, columns - column), std::min(side, rows - south)});
    }
  }
  return squares;
}

}  // namespace

Owners::Owners(const PixelGrid& grid, const std::vector<MultiPolygon>& areas,
               const Network& network, Metric metric, const ReportingStations& reports,
               std::function<PointMapping()> to_study, unsigned threads)
    : grid_(grid),
      areas_(grid, areas),
      to_study_(std::move(to_study)),
      workers_(std::max(1u, threads)) {
  // A place at which several stations report belongs to the first of them.
  std::vector<Point> positions;
  ReportingPlaces is_there(network.places().size(), false);
  for (std::uint32_t s = 0; s < reports.size(); ++s) {
    const PlaceIndex place = network.place_of(StationIndex{s});
    if (!reports[StationIndex{s}] || is_there[place]) continue;
    is_there.set(place, true);
    positions.push_back(network.places()[index(place)]);
    numbers_.push_back(static_cast<std::int32_t>(s) + 1);
  }
  if (!positions.empty()) places_ = nearest_places(positions, metric);
}

std::span<const std::int32_t> Owners::rows(int row, int count) {
  if (!places_) {
    rows_.assign(static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(count), 0);
    return rows_;
  }
  rows_ = areas_.rows(row, count, BlockOwners::waiting);
  const std::vector<PixelBlock> squares = squares_of(grid_.columns, row, count);
  in_parallel(squares.size(), static_cast<unsigned>(workers_.size()),
              [&](std::size_t worker, std::size_t i) {
                auto& settling = workers_[worker];
                if (!settling) {
                  settling = std::make_unique<BlockOwners>(grid_, *places_, numbers_, to_study_());
                }
                settling->settle(squares[i], {row, rows_});
              });
  return rows_;
}

}  // namespace thiessen
