#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/crs/crs.h"
#include "gdal/output/encoded_file.h"
#include "results/triangle_features.h"

namespace thiessen {

/// The triangles to be written, and the CRS in which they are and will be written: as CellsOutput.
struct TrianglesOutput : TriangleFeatures {
  std::optional<Crs> study_crs;
  std::optional<Crs> file_crs;
  double tolerance = 0.1;
};

/// The triangles as GeoJSON, in coordinates and decimals as cells_geojson says. One that is
/// narrower than coordinates can tell has no geometry, which a warning tells. `file` is the name of
/// the output in messages.
std::string triangles_geojson(const TrianglesOutput& output, const std::string& file,
                              Warnings& warnings);

/// The triangles in the format that the extension of `path` names, in a layer `delaunay`, as
/// cells_files writes cells.
std::vector<EncodedFile> triangles_files(const TrianglesOutput& output, const std::string& path,
                                         Warnings& warnings, const std::string& older = {});

}  // namespace thiessen
