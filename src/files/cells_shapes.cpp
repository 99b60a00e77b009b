#include "files/cells_shapes.h"

#include "base/utf8.h"
#include "files/shape_target.h"

namespace thiessen {

std::vector<MultiPolygon> cells_shapes(const CellsOutput& output,
                                       const std::optional<Crs>& target) {
  std::vector<MultiPolygon> shapes;
  shapes.reserve(output.cells.size());
  ShapeTarget in_target(output.study_crs, target, output.tolerance);
  for (const CellFeature& cell : output.cells)
    shapes.push_back(
        in_target.of(cell.shape, "the cell of station " + quoted(cell.station, 80), "cells"));
  return shapes;
}

}  // namespace thiessen
