#include "map/raster/block_owners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/interrupt.h"
#include "map/opencv/convex_fill.h"

namespace thiessen {
namespace {

/// How far from an edge, in columns and in rows, OpenCV may give a pixel to the wrong one of its
/// two cells. It is more than RivalCells::untold_within, and a little more than filled_beyond for
/// the rounding of the edge's ends.
constexpr double edge_reach = filled_beyond + 1.0 / 128;
/// Up to this fraction of a pixel beyond a centre counts as being at it.
constexpr double rounded_up_beyond = 0x1p-30;
static_assert(edge_reach > RivalCells::untold_within);

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
  if (settle_cells(positions, block, depth)) return;
  for_each_quarter(block, [&](const PixelBlock& quarter) {
    places_.keep_rivals(positions.ball(quarter), rivals_[depth], rivals_[depth + 1]);
    divide(positions, quarter, depth + 1);
  });
}

bool BlockOwners::settle_cells(const PixelPositions& positions, const PixelBlock& block,
                               std::size_t depth) {
  const std::vector<PlaceIndex>& rivals = rivals_[depth];
  if (rivals.size() > RivalCells::most) return false;
  if (!cells_.lay(positions.plane(block), block, places_, rivals)) return false;
  fill_cells(rivals, block);
  const std::span<const RivalCells::Cell> cells = cells_.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t k = 0; k < cells[i].count; ++k) {
      // Each edge is looked at from one of its sides, and a cut-off from none.
      const std::size_t beyond = cells[i].beyond[k];
      if (beyond >= i) continue;
      const Point from = cells[i].corners[k];
      const Point to = cells[i].next(k);
      const RivalCells::Edge edge(cells_, i, beyond, from, to, edge_reach + 2 * rounded_up_beyond);
      settle_edge(edge, from, to, positions, block, depth);
    }
  }
  return true;
}

// The largest cell is filled as all of the block, which is much cheaper than a polygon.
void BlockOwners::fill_cells(std::span<const PlaceIndex> rivals, const PixelBlock& block) {
  const std::span<const RivalCells::Cell> cells = cells_.cells();
  const auto number = [&](const RivalCells::Cell& cell) {
    return numbers_[index(rivals[cell.rival])];
  };
  const RivalCells::Cell* largest = &cells.front();
  double largest_area = 0;
  for (const RivalCells::Cell& cell : cells) {
    const double area = cell.doubled_area();
    if (!(area > largest_area)) continue;
    largest_area = area;
    largest = &cell;
  }
  fill(block, number(*largest));
  const PixelWindow window{&owner(block.column, block.row), block.columns, block.rows,
                           static_cast<std::size_t>(grid_.columns)};
  for (const RivalCells::Cell& cell : cells) {
    if (&cell != largest && cell.count > 0) fill_convex(cell.polygon(), number(cell), window);
  }
}

// Looks at all pixels of the block whose centres are within edge_reach of the edge: the part of it
// that is so near to a row lies between two columns.
void BlockOwners::settle_edge(const RivalCells::Edge& edge, Point from, Point to,
                              const PixelPositions& positions, const PixelBlock& block,
                              std::size_t depth) {
  constexpr double reach = edge_reach;
  // What is not negative is rounded down by cutting off its fraction. Edges end a pixel outside of
  // the block at most.
  const auto at_or_after = [](double p) {
    return static_cast<int>(std::max(p, 0.0) + 1 - rounded_up_beyond);
  };
  const auto at_or_before = [](double p) { return static_cast<int>(p + 1) - 1; };
  std::array<std::int32_t, RivalCells::most> numbers;
  for (std::size_t i = 0; i < edge.count(); ++i)
    numbers[i] = numbers_[index(rivals_[depth][edge.rival(i)])];
  if (to.y < from.y) std::swap(from, to);
  const int first = at_or_after(from.y - reach);
  const int last = std::min(block.rows - 1, at_or_before(to.y + reach));
  const double height = to.y - from.y;
  const double slope = height > 0 ? (to.x - from.x) / height : 0;
  for (int row = first; row <= last; ++row) {
    double west = from.x;
    double east = to.x;
    if (row - reach > from.y) west = from.x + (row - reach - from.y) * slope;
    if (row + reach < to.y) east = from.x + (row + reach - from.y) * slope;
    if (east < west) std::swap(west, east);
    const int end = std::min(block.columns - 1, at_or_before(east + reach));
    for (int column = at_or_after(west - reach); column <= end; ++column) {
      const PixelBlock pixel{block.column + column, block.row + row, 1, 1};
      if (const auto nearest = edge.nearest(column, row)) {
        owner(pixel.column, pixel.row) = numbers[*nearest];
      } else {
        places_.keep_rivals(positions.ball(pixel), rivals_[depth], rivals_[depth + 1]);
        divide(positions, pixel, depth + 1);
      }
    }
  }
}

void BlockOwners::settle_one_by_one(const PixelBlock& block) {
  std::vector<PixelBlock> pixels;
  std::vector<Point> centres;
  for (int row = block.row; row < block.row + block.rows; ++row) {
    for (int column = block.column; column < block.column + block.columns; ++column) {
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
    std::fill_n(first, block.columns, number);
  }
}

}  // namespace thiessen
