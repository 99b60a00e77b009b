#include "map/sheet/map_grid.h"

#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

/// 0 where the page has the proportions of paper, and less the farther it is from that.
double likeness_to_a_page(const MapGrid& grid, const GridRoom& room, const GridGaps& gaps) {
  const double width = room.width + room.beside;
  const double height = room.below + grid.rows * (grid.height + gaps.above);
  return -std::abs(std::log(width / height) - std::log(2) / 2);
}

}  // namespace

MapGrid best_grid(std::size_t maps, double aspect, const GridRoom& room, const GridGaps& gaps) {
  const int count = static_cast<int>(maps);
  MapGrid best;
  double most = -HUGE_VAL;
  for (int rows = 1; rows <= count; ++rows) {
    const int columns = (count + rows - 1) / rows;
    if ((count + columns - 1) / columns < rows) continue;
    MapGrid grid{columns, rows, (room.width - (columns - 1) * gaps.across) / columns, 0};
    if (grid.width < 1) continue;
    grid.height = room.height > 0 ? room.height / rows - gaps.above
                                  : static_cast<int>(std::lround(grid.width / aspect));
    if (grid.height < 1) continue;
    const double good = room.height > 0 ? std::min<double>(grid.width, grid.height * aspect)
                                        : likeness_to_a_page(grid, room, gaps);
    if (good <= most) continue;
    most = good;
    best = grid;
  }
  return best;
}

std::vector<PixelBox> places_in(const MapGrid& grid, std::size_t maps, int left, int top,
                                const GridGaps& gaps) {
  std::vector<PixelBox> places;
  for (int i = 0; i < static_cast<int>(maps); ++i) {
    const int column = i % grid.columns;
    const int row = i / grid.columns;
    places.push_back({left + column * (grid.width + gaps.across),
                      top + row * (grid.height + gaps.above) + gaps.above, grid.width,
                      grid.height});
  }
  return places;
}

bool is_lowest(const MapGrid& grid, std::size_t maps, std::size_t map) {
  return map + static_cast<std::size_t>(grid.columns) >= maps;
}

}  // namespace thiessen
