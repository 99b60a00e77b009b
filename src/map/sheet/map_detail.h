#pragma once

#include <cstddef>

namespace thiessen {

/// What is drawn on a map beside the ground of its cells and basins.
struct MapDetail {
  bool has_gauges = true;
  bool has_labels = true;  ///< of gauges and of basins
  bool has_cell_outlines = true;
  bool has_basin_outlines = true;
  bool has_basin_edges = true;  ///< that are drawn: all of the Earth has none
};

/// The side in pixels of one of so many shapes that share a map.
double side_of_each(std::size_t shapes, double pixels);

/// Leaves out the outlines of cells or basins that are only a few pixels wide on a map of so many,
/// where lines would cover them. A single one is always outlined.
void thin_out(MapDetail& detail, std::size_t cells, std::size_t basins, double pixels);

}  // namespace thiessen
