#pragma once

#include <span>
#include <string>

#include "outlines/vertex_rounding.h"
#include "results/triangle_features.h"

namespace thiessen {

/// The triangles as GeoJSON (RFC 7946), one feature a line, in their order, with the properties a,
/// b and c, the ids of the stations at its corners. `shapes` holds the geometry to write for each,
/// as cells_geojson requires it. What is said of how the file was made stands before them.
std::string triangles_geojson(const TriangleFeatures& features,
                              std::span<const MultiPolygon> shapes, const VertexRounding& rounding);

}  // namespace thiessen
