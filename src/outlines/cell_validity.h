#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/polygon.h"
#include "outlines/vertex_rounding.h"

namespace thiessen {

/// The shapes of the cells of one or more basins, about to be written.
struct CellShapes {
  std::vector<MultiPolygon> shapes;
  /// The number of the basin of each cell; the cells of a basin stand together.
  std::vector<std::size_t> basins;
  std::size_t collapsed = 0;  ///< basins in whose cells something was collapsed
};

/// Finds the decimals of the cells' vertices (see VertexRounding). In basins with a cell that is
/// somewhere narrower than a tenth of the last of `decimals`, what is so narrow is collapsed before
/// (see collapsed), unless a cell would be lost. The cells that are no valid shape even so are the
/// result's faulty().
VertexRounding round_cells(CellShapes& cells, int decimals);

/// Makes the cells valid shapes in doubles: in basins with a cell that is not, what is narrower
/// than `grid`, or than less where a cell would be lost, is collapsed. Returns the cells that are
/// no valid shape even so. Cost: one check of validity a cell.
std::vector<std::size_t> make_valid(CellShapes& cells, double grid);

/// A grid for cells in a plane of unknown unit: 1e-11 of their largest coordinate, as a power of
/// ten.
double finest_grid(std::span<const MultiPolygon> shapes);

}  // namespace thiessen
