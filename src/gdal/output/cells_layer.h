#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gdal/crs/crs.h"
#include "gdal/output/encoded_file.h"
#include "results/cell_features.h"

namespace thiessen {

/// The part of a path's file name after its last dot, in lower case; empty where there is no dot.
std::string extension_of(const std::string& path);

/// Checks that a driver of GDAL's writes cells to `path`. Throws Error, listing the known
/// extensions, where none does.
void require_cells_driver(const std::string& path);

/// Encodes the cells as a layer, in the format of `path`'s extension. The first file is that of
/// `path`; others lie beside it. `shapes` are the outlines of the cells, in `crs`. Throws Error
/// where there is no such format, and where it cannot hold the cells.
std::vector<EncodedFile> write_cells_layer(const CellFeatures& features,
                                           std::span<const MultiPolygon> shapes,
                                           const std::optional<Crs>& crs, const std::string& path);

}  // namespace thiessen
