#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/polygon.h"
#include "io/crs.h"
#include "text/attributes.h"

namespace thiessen {

/// One cell to be written: a station's part of a basin.
struct CellFeature {
  std::string station;
  std::optional<std::string> basin;  ///< nothing where the run has no basins
  double area_km2 = 0;               ///< (CRS units)^2 where the unit is unknown
  double weight = 0;
  double rainfall = 0;            ///< NaN: no value. Written where CellsOutput::has_rainfall
  std::size_t attribute_row = 0;  ///< which row of CellsOutput::attributes is the station's
  MultiPolygon shape;             ///< in the study's coordinates; outer rings counter-clockwise
};

/// What is to be written. Neighbouring cells share their edges vertex for vertex, with equal
/// doubles.
struct CellsOutput {
  std::vector<CellFeature> cells;
  bool has_rainfall = false;
  const Attributes* attributes = nullptr;  ///< where every field of the station is carried along
  std::optional<Crs> study_crs;            ///< of the shapes; none: a plane without a CRS
  std::optional<Crs> file_crs;             ///< of formats other than GeoJSON
  double tolerance = 0.1;                  ///< metres that an edge may lie from the true one
};

/// A file as it is to lie on disk.
struct EncodedFile {
  std::string name;  ///< its path: as asked for, or a side file's beside it
  std::string bytes;
};

/// RFC 7946: WGS 84, outer rings counter-clockwise, cut at the antimeridian, 7 decimals at a
/// tolerance of 0.1 m and, vertex by vertex, as many more as it takes for no cell to collapse or
/// cross itself; cells that share a vertex write it alike. A plane without a CRS writes its own
/// coordinates, all digits. Written by a writer of our own: GDAL's knows one number of decimals for
/// the whole file and writes 0.1 as 0.10000000000000001. Cost: one check of validity a cell, n log
/// n.
std::string cells_geojson(const CellsOutput& output);

/// The cells in the format of `path`'s extension: the first file is that of `path`, others lie
/// beside it. GeoJSON as above, all else by GDAL in `file_crs`. Throws Error, with the list of
/// known extensions, where there is no such format, and where the format cannot hold the cells.
std::vector<EncodedFile> cells_files(const CellsOutput& output, const std::string& path);

/// Throws Error, listing the known extensions, where cells_files could not write to `path`.
void require_cells_format(const std::string& path);

}  // namespace thiessen
