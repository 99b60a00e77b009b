#pragma once

#include "base/file.h"
#include "tessellation/number_of.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// Writes a row of CSV for the Voronoi cell of every point, in the order of the points' numbers:
/// `point,area,sides` in the plane, `point,volume,sides` in space. Where a cell is unbounded, its
/// area or volume is `inf`. Its sides are its edges, in space its faces, those that never end
/// included. Numbers have the fewest digits that read back to the same double. Accuracy and cost:
/// those of find_cell for each point.
template <int Dimension>
void write_cell_measures(OutputFile& file, const Tessellation<Dimension>& tessellation,
                         const NumberOf& number_of);

}  // namespace thiessen
