#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "gdal/crs/crs.h"
#include "gdal/output/encoded_file.h"
#include "gdal/output/layer_formats.h"
#include "results/cell_features.h"

namespace thiessen {

/// Checks that a driver of GDAL's writes cells to `path`. Throws Error, listing the known
/// extensions, where none does.
void require_cells_driver(const std::string& path);

/// Whether the format of `path` says how each cell is coloured, and what it is called: KML.
bool holds_colours(const std::string& path);

/// Encodes the cells as a layer, in the format of `path`'s extension. The first file is that of
/// `path`; others lie beside it. `shapes` are the outlines of the cells, in `crs`. `older` holds
/// the bytes of a GeoPackage whose other layers are kept; it is empty where there is none.
///
/// What GDAL warns of, and fields that the format calls otherwise, go to `warnings`. Throws Error
/// where there is no such format, and where it cannot hold the cells or a text of theirs whole.
std::vector<EncodedFile> write_cells_layer(const CellFeatures& features,
                                           std::span<const MultiPolygon> shapes,
                                           const std::optional<Crs>& crs, const std::string& path,
                                           const std::string& older, Warnings& warnings);

/// The cells as rows of CSV with a header, for a database: the fields of their layer, then
/// `geometry_name` with the shape in the hexadecimal digits of EWKB, empty where there is none.
/// Numbers have the fewest digits that read back. Returns the names of the columns.
std::vector<std::string> append_cell_rows(OutputFile& file, const CellFeatures& features,
                                          std::span<const MultiPolygon> shapes,
                                          const std::string& geometry_name, int srid);

}  // namespace thiessen
