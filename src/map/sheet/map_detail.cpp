#include "map/sheet/map_detail.h"

#include <algorithm>
#include <cmath>

namespace thiessen {

double side_of_each(std::size_t shapes, double pixels) {
  return std::sqrt(pixels / static_cast<double>(std::max<std::size_t>(shapes, 1)));
}

void thin_out(MapDetail& detail, std::size_t cells, std::size_t basins, double pixels) {
  constexpr double least_side = 4.5;  // pixels
  if (cells > 1 && side_of_each(cells, pixels) < least_side) detail.has_cell_outlines = false;
  if (basins > 1 && side_of_each(basins, pixels) < least_side) detail.has_basin_outlines = false;
}

}  // namespace thiessen
