#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "map/raster/pixel_positions.h"

namespace thiessen {

/// Gives a raster's pixels to the places nearest to their centres, block by block. A block of which
/// all centres lie in a ball with one rival is the rival's; others are quartered, and a pixel with
/// several rivals is decided by its own position, not the polynomials'. So the result is that of
/// asking every pixel, but for the work along cells' edges only. One for a thread.
class BlockOwners {
 public:
  /// What a pixel holds that waits for its owner.
  static constexpr std::int32_t waiting = -1;

  /// Some of the raster's rows.
  struct Rows {
    int first = 0;
    std::span<std::int32_t> owners;  ///< row by row from the north
  };

  /// `numbers`: what stands for each place; ascending. All but `to_study` must outlive it.
  BlockOwners(const PixelGrid& grid, const NearestPlaces& places,
              std::span<const std::int32_t> numbers, PointMapping to_study);

  /// Gives every pixel of the block, one of the rows', that waits its owner's number, or 0 where
  /// the projection ends. Cost: in proportion to the pixels, which are only filled, and to those
  /// along the edges times the places that meet there. Stops with Interrupted where a signal came.
  void settle(const PixelBlock& block, const Rows& rows);

 private:
  void settle(const PixelBlock& block);
  void divide(const PixelPositions& positions, const PixelBlock& block, std::size_t depth);
  void settle_one_by_one(const PixelBlock& block);
  void settle_pixel(const PixelBlock& pixel, Point centre, std::span<const PlaceIndex> rivals);
  void fill(const PixelBlock& block, std::int32_t number);
  bool waits(const PixelBlock& block) const;
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
  std::vector<std::vector<PlaceIndex>> rivals_;  ///< by how often the block was quartered
};

}  // namespace thiessen
