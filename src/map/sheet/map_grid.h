#pragma once

#include <cstddef>
#include <vector>

#include "map/ink/canvas.h"

namespace thiessen {

/// How several maps stand on a page: in rows from the upper left, all of one size.
struct MapGrid {
  int columns = 1;
  int rows = 1;
  int width = 0;  ///< of a map, in pixels; 0 where there is no room
  int height = 0;
};

/// What is left free in a grid, in pixels.
struct GridGaps {
  int across = 0;  ///< between the maps of a row
  int above = 0;   ///< over each map, for its heading
};

/// The room for a grid, and for what stands beside it on the page, in pixels.
struct GridRoom {
  int width = 0;
  int height = 0;  ///< 0: as the maps need it
  int beside = 0;
  int below = 0;  ///< and above
};

/// The grid in which `maps` maps, each `aspect` times as wide as high, are largest; where the
/// height is open, that whose page is nearest to sqrt(2) times as wide as high. Of equally good
/// ones it is that of fewest rows. No row is empty. Cost: the maps.
MapGrid best_grid(std::size_t maps, double aspect, const GridRoom& room, const GridGaps& gaps);

/// The places of the maps in a grid whose upper left is (`left`, `top`).
std::vector<PixelBox> places_in(const MapGrid& grid, std::size_t maps, int left, int top,
                                const GridGaps& gaps);

/// Whether nothing stands below a map of the grid.
bool is_lowest(const MapGrid& grid, std::size_t maps, std::size_t map);

}  // namespace thiessen
