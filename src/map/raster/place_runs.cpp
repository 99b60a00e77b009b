#include "map/raster/place_runs.h"

#include <algorithm>

namespace thiessen {
namespace {

struct OwnedRun {
  PlaceIndex place;
  PixelRun run;
};

constexpr int rows_at_once = 256;

void add_runs_of_row(std::span<const std::int32_t> owners, std::size_t first,
                     const Network& network, std::vector<OwnedRun>& runs) {
  for (std::size_t i = 0; i < owners.size();) {
    const std::int32_t owner = owners[i];
    const std::size_t begin = i;
    while (i < owners.size() && owners[i] == owner) ++i;
    if (owner == 0) continue;
    const auto station = StationIndex{static_cast<std::uint32_t>(owner - 1)};
    runs.push_back(
        {network.place_of(station),
         {static_cast<std::uint32_t>(first + begin), static_cast<std::uint32_t>(first + i)}});
  }
}

}  // namespace

PlaceRuns::PlaceRuns(const PixelGrid& grid, const Network& network, Owners& owners)
    : first_(network.places().size() + 1, 0), pixels_(network.places().size(), 0) {
  std::vector<OwnedRun> runs;
  const auto columns = static_cast<std::size_t>(grid.columns);
  for (int row = 0; row < grid.rows; row += rows_at_once) {
    const int count = std::min(rows_at_once, grid.rows - row);
    const std::span<const std::int32_t> some = owners.rows(row, count);
    for (std::size_t r = 0; r < static_cast<std::size_t>(count); ++r) {
      add_runs_of_row(some.subspan(r * columns, columns),
                      (static_cast<std::size_t>(row) + r) * columns, network, runs);
    }
  }
  for (const OwnedRun& owned : runs) {
    ++first_[index(owned.place) + 1];
    pixels_[index(owned.place)] += owned.run.end - owned.run.begin;
    all_pixels_ += owned.run.end - owned.run.begin;
  }
  for (std::size_t p = 1; p < first_.size(); ++p) first_[p] += first_[p - 1];
  runs_.resize(runs.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const OwnedRun& owned : runs) runs_[next[index(owned.place)]++] = owned.run;
}

}  // namespace thiessen
