#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gdal/crs.h"
#include "gdal/encoded_file.h"
#include "results/cell_features.h"

namespace thiessen {

/// What follows the last dot of a path's file name, in lower case; empty where there is none.
std::string extension_of(const std::string& path);

/// Throws Error, listing the known extensions, where no driver of GDAL's writes cells to `path`.
void require_cells_driver(const std::string& path);

/// The cells as a layer, in the format of `path`'s extension: the first file is that of `path`,
/// others lie beside it. `shapes`: what each is to be drawn as, in `crs`. Throws Error where there
/// is no such format, and where it cannot hold the cells.
std::vector<EncodedFile> write_cells_layer(const CellFeatures& features,
                                           std::span<const MultiPolygon> shapes,
                                           const std::optional<Crs>& crs, const std::string& path);

}  // namespace thiessen
