#pragma once

#include <string>

namespace thiessen {

/// Starts GDAL, once: only the drivers of the contract (GeoJSON, GeoPackage, Shapefile, FlatGeobuf,
/// KML, spreadsheets, PostGIS), nothing fetched over a network, and no effect of the user's
/// environment (variables of GDAL's and PROJ's own options are removed from it). Call it before
/// threads start.
void start_gdal();

/// Whether `file` is for GDAL and not a CSV: by its extension, `PG:`, an archive's path, or what
/// its first bytes say. Throws Error for what no command reads: a folder, a missing file, a URL, a
/// connection other than PG:, a virtual file other than of a local archive, JSON as an argument.
bool read_by_gdal(const std::string& file);

}  // namespace thiessen
