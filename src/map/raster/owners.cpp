#include "map/raster/owners.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"

namespace thiessen {
namespace {

/// Parts some rows of the raster into squares. The last square of each row of squares may be
/// narrower, and the last row of squares lower.
std::vector<PixelBlock> squares_of(int columns, int row, int rows) {
  constexpr int side = 256;
  std::vector<PixelBlock> squares;
  for (int south = 0; south < rows; south += side) {
    for (int column = 0; column < columns; column += side) {
      squares.push_back(
          {column, row + south, std::min(side, columns - column), std::min(side, rows - south)});
    }
  }
  return squares;
}

/// Calls `visit(row, first, end)` for every run of pixels in the block that are in an area; the
/// spans' rows count from `first_row`.
template <typename Visit>
void for_each_run(const AreaSpans& spans, int first_row, const PixelBlock& block, Visit&& visit) {
  const int block_end = block.column + block.columns;
  for (int row = block.row; row < block.row + block.rows; ++row) {
    const std::span<const PixelSpan> all = spans.row(row - first_row);
    auto span = std::partition_point(all.begin(), all.end(),
                                     [&](PixelSpan s) { return s.end <= block.column; });
    for (; span != all.end() && span->first < block_end; ++span)
      visit(row, std::max(span->first, block.column), std::min(span->end, block_end));
  }
}

/// The smallest block that holds the pixels of `block` that are in an area; it has no rows where
/// there are none.
PixelBlock within_areas(const AreaSpans& spans, int first_row, const PixelBlock& block) {
  int west = block.column + block.columns;
  int east = block.column;
  int north = block.row + block.rows;
  int south = block.row;
  for_each_run(spans, first_row, block, [&](int row, int first, int end) {
    west = std::min(west, first);
    east = std::max(east, end);
    north = std::min(north, row);
    south = row + 1;
  });
  return {west, north, std::max(0, east - west), std::max(0, south - north)};
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
  rows_.resize(static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(count));
  if (!places_) {
    std::fill(rows_.begin(), rows_.end(), 0);
    return rows_;
  }
  const AreaSpans spans = areas_.rows(row, count);
  const std::vector<PixelBlock> squares = squares_of(grid_.columns, row, count);
  in_parallel(squares.size(), static_cast<unsigned>(workers_.size()),
              [&](std::size_t worker, std::size_t i) {
                const PixelBlock inside = within_areas(spans, row, squares[i]);
                if (inside.rows > 0) {
                  auto& settling = workers_[worker];
                  if (!settling) {
                    settling =
                        std::make_unique<BlockOwners>(grid_, *places_, numbers_, to_study_());
                  }
                  settling->settle(inside, {row, rows_});
                }
                clear_outside(spans, row, squares[i]);
              });
  return rows_;
}

void Owners::clear_outside(const AreaSpans& spans, int first_row, const PixelBlock& square) {
  for (int row = square.row; row < square.row + square.rows; ++row) {
    const auto before =
        static_cast<std::size_t>(row - first_row) * static_cast<std::size_t>(grid_.columns);
    std::int32_t* const pixels = rows_.data() + before;
    int cleared = square.column;
    for_each_run(spans, first_row, {square.column, row, square.columns, 1},
                 [&](int, int first, int end) {
                   std::fill(pixels + cleared, pixels + first, 0);
                   cleared = end;
                 });
    std::fill(pixels + cleared, pixels + square.column + square.columns, 0);
  }
}

}  // namespace thiessen
