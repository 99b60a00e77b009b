#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/pixel_grid.h"
#include "map/raster/owners.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// Pixels of one row that lie side by side. Pixels are numbered row by row from the north.
struct PixelRun {
  std::uint32_t begin;
  std::uint32_t end;  ///< the one after the last
};

/// The pixels that each place of a network owns, as runs in rising order. Memory: 8 bytes a run.
class PlaceRuns {
 public:
  /// Asks for the owners of all rows. Stops with Interrupted where a signal came.
  PlaceRuns(const PixelGrid& grid, const Network& network, Owners& owners);

  std::span<const PixelRun> of(PlaceIndex place) const {
    const std::size_t first = first_[index(place)];
    return std::span(runs_).subspan(first, first_[index(place) + 1] - first);
  }
  std::size_t pixels_of(PlaceIndex place) const { return pixels_[index(place)]; }
  /// How many pixels have an owner.
  std::size_t pixels() const { return all_pixels_; }

 private:
  std::vector<PixelRun> runs_;       // place by place
  std::vector<std::size_t> first_;   // by place: where its runs begin
  std::vector<std::size_t> pixels_;  // by place
  std::size_t all_pixels_ = 0;
};

}  // namespace thiessen
