#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// Starts GDAL, once, with only the drivers that are promised (GeoJSON, GeoPackage, Shapefile,
/// FlatGeobuf, KML, spreadsheets, PostGIS). Nothing is fetched over a network, and the user's
/// environment has no effect, because variables of GDAL's and PROJ's own options are removed from
/// it. Call it before threads start, since the environment is changed.
///
/// A host in whose process this runs (the module for Python: the library of study/thiessen.h has no
/// GDAL) finds changed, for all that use the same GDAL: those variables are gone, from the host's
/// children as well; spreadsheets are read as text, folders are not listed when files are opened,
/// curves become lines in steps of 0.1 degrees, and neither GDAL nor PROJ fetches anything.
void start_gdal();

/// Starts GDAL, and registers its drivers of all formats but of those that need another machine or
/// another program: for rasters to be read, which may be of any format, and for cells in a format
/// that is not promised. Where another part of the process uses GDAL, too, those may be there all
/// the same: what it has registered stays.
void register_local_drivers();

/// Whether a driver needs another machine or another program.
bool is_remote_driver(std::string_view name);

/// The names of all drivers of rasters that are registered now and need no other machine and no
/// other program: what a raster may be opened with.
std::vector<std::string> local_raster_drivers();

}  // namespace thiessen
