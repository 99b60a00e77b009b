#pragma once

#include <span>
#include <string>

#include "outlines/vertex_rounding.h"
#include "results/cell_features.h"

namespace thiessen {

/// The cells as GeoJSON (RFC 7946), one feature a line, in their order. `shapes` holds the geometry
/// to write for each cell, outer rings counter-clockwise, in WGS 84 longitude and latitude cut at
/// the antimeridian or in the coordinates of a plane; a cell without a shape has a null geometry.
/// What the file says of how it was made stands before them, in a member `made_by` of software,
/// metric, plane, tolerance, method and unit. What the values of rainfall are stands in a member
/// `rainfall` of the collection. Cost: linear.
///
/// This writer is our own because GDAL's has one number of decimals for the whole file and writes
/// 0.1 as 0.10000000000000001.
std::string cells_geojson(const CellFeatures& features, std::span<const MultiPolygon> shapes,
                          const VertexRounding& rounding);

}  // namespace thiessen
