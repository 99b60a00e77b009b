#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/raster/pixel_positions.h"
#include "map/raster/rival_cells.h"

namespace thiessen {

/// Gives a raster's pixels to the places nearest to their centres, block by block. A block whose
/// centres all lie in a ball with a single rival belongs to that rival. In one with some more,
/// their cells are filled by OpenCV, and the pixels along the cells' edges are decided one by one;
/// other blocks are quartered. Where the block's plane does not tell, pixels are decided by their
/// own position. So the result is the same as if every pixel were asked. Each thread needs one of
/// its own.
class BlockOwners {
 public:
  /// Some rows of the raster, and the owners of their pixels.
  struct Rows {
    int first = 0;
    std::span<std::int32_t> owners;  ///< row by row from the north
  };

  /// `numbers` holds the number to be written for each place, in ascending order. All arguments but
  /// `to_study` must outlive the object.
  BlockOwners(const PixelGrid& grid, const NearestPlaces& places,
              std::span<const std::int32_t> numbers, PointMapping to_study);

  /// Writes into each pixel of the block, which lies in `rows`, the number of its owner, or 0 where
  /// the projection ends. Cost: the pixels, which are only filled, and those along the edges times
  /// the places that meet there. Stops with Interrupted where a signal came.
  void settle(const PixelBlock& block, const Rows& rows);

 private:
  void settle(const PixelBlock& block);
  void divide(const PixelPositions& positions, const PixelBlock& block, std::size_t depth);
  bool settle_cells(const PixelPositions& positions, const PixelBlock& block, std::size_t depth);
  void fill_cells(std::span<const PlaceIndex> rivals, const PixelBlock& block);
  void settle_edge(const RivalCells::Edge& edge, Point from, Point to,
                   const PixelPositions& positions, const PixelBlock& block, std::size_t depth);
  void settle_one_by_one(const PixelBlock& block);
  void settle_pixel(const PixelBlock& pixel, Point centre, std::span<const PlaceIndex> rivals);
  void fill(const PixelBlock& block, std::int32_t number);
  std::int32_t& owner(int column, int row) const {
    return rows_.owners[static_cast<std::size_t>(row - rows_.first) *
                            static_cast<std::size_t>(grid_.columns) +
                        static_cast<std::size_t>(column)];
  }

  const PixelGrid& grid_;
  const NearestPlaces& places_;
  std::span<const std::int32_t> numbers_;
  PointMapping to_study_;
  Rows rows_;
  /// The rivals by the number of times that the block was quartered.
  std::vector<std::vector<PlaceIndex>> rivals_;
  RivalCells cells_;
};

}  // namespace thiessen
