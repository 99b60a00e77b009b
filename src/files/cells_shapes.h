#pragma once

#include <optional>
#include <vector>

#include "files/cells_file.h"
#include "gdal/crs/crs.h"
#include "geometry/polygon.h"

namespace thiessen {

/// Takes the cells' shapes into `target`, in their order. Edges are straight in the study's
/// coordinates: in another CRS they are subdivided until they lie within half the tolerance, at the
/// same points for both neighbours. Longitudes are cut at the antimeridian. Without a CRS shapes
/// stay as they are. Throws Error where a cell reaches outside the area of `target`, or of
/// the study's CRS.
std::vector<MultiPolygon> cells_shapes(const CellsOutput& output, const std::optional<Crs>& target);

}  // namespace thiessen
