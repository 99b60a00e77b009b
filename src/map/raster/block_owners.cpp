#include "map/raster/block_owners.h"

#include <cmath>
#include <utility>

#include "base/interrupt.h"

namespace thiessen {
namespace {

/// Calls `work` for each quarter of the block, or each half where the block is one pixel wide or
/// high.
template <typename Work>
void for_each_quarter(const PixelBlock& block, Work&& work) {
  const int west = (block.columns + 1) / 2;
  const int north = (block.rows + 1) / 2;
  for (const auto& [row, rows] :
       {std::pair(block.row, north), std::pair(block.row + north, block.rows - north)}) {
    for (const auto& [column, columns] :
         {std::pair(block.column, west), std::pair(block.column + west, block.columns - west)}) {
      if (rows > 0 && columns > 0) work(PixelBlock{column, row, columns, rows});
    }
  }
}

}  // namespace

BlockOwners::BlockOwners(const PixelGrid& grid, const NearestPlaces& places,
                         std::span<const std::int32_t> numbers, PointMapping to_study)
    : grid_(grid), places_(places), numbers_(numbers), to_study_(std::move(to_study)), rivals_(1) {}

void BlockOwners::settle(const PixelBlock& block, const Rows& rows) {
  rows_ = rows;
  settle(block);
}

void BlockOwners::settle(const PixelBlock& block) {
  constexpr int few = 8;
  throw_if_interrupted();
  if (!waits(block)) return;
  const auto positions = PixelPositions::fit(grid_, block, to_study_, places_);
  if (positions) {
    places_.find_rivals(positions->ball(block), rivals_[0]);
    divide(*positions, block, 0);
  } else if (block.columns <= few && block.rows <= few) {
    settle_one_by_one(block);
  } else {
    for_each_quarter(block, [&](const PixelBlock& quarter) { settle(quarter); });
  }
}

// Expects the rivals of the block in rivals_[depth].
void BlockOwners::divide(const PixelPositions& positions, const PixelBlock& block,
                         std::size_t depth) {
  if (rivals_[depth].size() == 1) return fill(block, numbers_[index(rivals_[depth].front())]);
  if (block.is_pixel()) {
    std::vector<Point> centre{grid_.centre(block.column, block.row)};
    to_study_(centre);
    return settle_pixel(block, centre.front(), rivals_[depth]);
  }
  throw_if_interrupted();
  if (rivals_.size() < depth + 2) rivals_.resize(depth + 2);
  for_each_quarter(block, [&](const PixelBlock& quarter) {
    if (!waits(quarter)) return;
    places_.keep_rivals(positions.ball(quarter), rivals_[depth], rivals_[depth + 1]);
    divide(positions, quarter, depth + 1);
  });
}

void BlockOwners::settle_one_by_one(const PixelBlock& block) {
  std::vector<PixelBlock> pixels;
  std::vector<Point> centres;
  for (int row = block.row; row < block.row + block.rows; ++row) {
    for (int column = block.column; column < block.column + block.columns; ++column) {
      if (owner(column, row) != waiting) continue;
      pixels.push_back({column, row, 1, 1});
      centres.push_back(grid_.centre(column, row));
    }
  }
  to_study_(centres);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Direction there = places_.in_space(centres[i]);
    if (!std::isfinite(there.x + there.y + there.z)) {
      fill(pixels[i], 0);
      continue;
    }
    places_.find_rivals({there, places_.rounding(there)}, rivals_[0]);
    settle_pixel(pixels[i], centres[i], rivals_[0]);
  }
}

void BlockOwners::settle_pixel(const PixelBlock& pixel, Point centre,
                               std::span<const PlaceIndex> rivals) {
  const auto nearest = places_.nearest(centre, rivals);
  fill(pixel, nearest ? numbers_[index(*nearest)] : 0);
}

void BlockOwners::fill(const PixelBlock& block, std::int32_t number) {
  for (int row = block.row; row < block.row + block.rows; ++row) {
    std::int32_t* const first = &owner(block.column, row);
    for (int i = 0; i < block.columns; ++i) first[i] = first[i] == waiting ? number : first[i];
  }
}

bool BlockOwners::waits(const PixelBlock& block) const {
  for (int row = block.row; row < block.row + block.rows; ++row) {
    const std::int32_t* const first = &owner(block.column, row);
    for (int i = 0; i < block.columns; ++i) {
      if (first[i] == waiting) return true;
    }
  }
  return false;
}

}  // namespace thiessen
