#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/crs/crs.h"
#include "gdal/output/encoded_file.h"
#include "results/triangle_features.h"

namespace thiessen {

/// Encodes triangles as a layer `delaunay` with the fields a, b and c, in the format of `path`'s
/// extension. `shapes` are their outlines in `crs`. `older`, what goes to `warnings` and what is
/// thrown are as of write_cells_layer.
std::vector<EncodedFile> write_triangles_layer(const TriangleFeatures& features,
                                               std::span<const MultiPolygon> shapes,
                                               const std::optional<Crs>& crs,
                                               const std::string& path, const std::string& older,
                                               Warnings& warnings);

}  // namespace thiessen
