#pragma once

namespace thiessen {

/// Starts GDAL, once, with only the drivers that are promised (GeoJSON, GeoPackage, Shapefile,
/// FlatGeobuf, KML, spreadsheets, PostGIS). Nothing is fetched over a network, and the user's
/// environment has no effect, because variables of GDAL's and PROJ's own options are removed from
/// it. Call it before threads start, since the environment is changed.
void start_gdal();

/// Starts GDAL, and registers its drivers of all formats but of those that need another machine or
/// another program: for rasters to be read, which may be of any format, and for cells in a format
/// that is not promised.
void register_local_drivers();

}  // namespace thiessen
