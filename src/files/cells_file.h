#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "files/database/database_table.h"
#include "gdal/crs/crs.h"
#include "gdal/output/encoded_file.h"
#include "results/cell_features.h"

namespace thiessen {

/// The cells to be written, and the CRS in which they are and will be written.
struct CellsOutput : CellFeatures {
  std::optional<Crs> study_crs;  ///< CRS of the shapes; nothing for a plane without a CRS
  std::optional<Crs> file_crs;   ///< CRS of formats other than GeoJSON
  double tolerance = 0.1;        ///< metres that an edge may lie from the true one
};

/// The cells as GeoJSON by RFC 7946: WGS 84, outer rings counter-clockwise, cut at the
/// antimeridian. Coordinates have 7 decimals at a tolerance of 0.1 m, and vertex by vertex as many
/// more as it takes for no cell to collapse or cross itself; cells that share a vertex write it
/// alike. Needles and slivers narrower than a hundredth of the tolerance are collapsed (see
/// round_cells), which a notice tells; a cell that is narrower than that as a whole has no
/// geometry, which a warning tells. `file` is the name of the output in messages. A plane without a
/// CRS writes its own coordinates with all digits. Throws Error with the cells that are no valid
/// shape even so. Cost: one check of validity a cell, n log n.
std::string cells_geojson(const CellsOutput& output, const std::string& file, Warnings& warnings);

/// Hands over cells one after the other, until `take` returns false.
using CellSource = std::function<void(const std::function<bool(const CellFeature& cell)>& take)>;

/// Appends to `file` what cells_geojson returns of the cells of a source, and holds one at a time.
/// `output` tells what they have in common; it has no cells itself. Returns false, with nothing
/// appended, where all cells have to be looked at before one is written: where vertices are
/// rounded, as in longitude and latitude, and where a cell has no valid shape. Requires a file to
/// which nothing was appended.
bool append_cells_geojson(OutputFile& file, const CellsOutput& output, const CellSource& cells);

/// The cells in the format that the extension of `path` names: the first file is `path` itself,
/// others lie beside it. GeoJSON is written as cells_geojson says, all other formats by GDAL in
/// `file_crs`. Every cell is checked to be valid, slivers being collapsed in basins where one is
/// not, and in formats that round coordinates it is read back and checked again. `older` holds the
/// bytes of a GeoPackage whose other layers are kept; it is empty where there is none. A field that
/// the format calls otherwise is told in `warnings`, and so is what GDAL warns of, and what is
/// collapsed. Throws Error,
/// with the list of known extensions, where there is no such format, and where the format cannot
/// hold the cells.
std::vector<EncodedFile> cells_files(const CellsOutput& output, const std::string& path,
                                     Warnings& warnings, const std::string& older = {});

/// Makes a table of the cells in a database, in `file_crs`, each checked to be valid as in
/// cells_files. Warns where that CRS has no SRID. Throws Error and Interrupted.
void cells_table(const CellsOutput& output, DatabaseTable& table, Warnings& warnings);

/// Warns of each attribute of the stations that has another name beside the cells' own fields, with
/// both names. `file` is the name of the output in messages.
void warn_of_new_names(const CellsOutput& output, const std::string& file, Warnings& warnings);

/// Whether the cells of a file of that name are written as cells_geojson says.
bool is_cells_geojson(const std::string& path);

/// Throws Error, listing the known extensions, where cells_files could not write to `path`.
void require_cells_format(const std::string& path);

}  // namespace thiessen
