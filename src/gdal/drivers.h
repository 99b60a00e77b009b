#pragma once

namespace thiessen {

/// Starts GDAL, once: only the drivers of the contract (GeoJSON, GeoPackage, Shapefile, FlatGeobuf,
/// KML, spreadsheets, PostGIS), nothing fetched over a network, and no effect of the user's
/// environment (variables of GDAL's and PROJ's own options are removed from it). Call it before
/// threads start.
void start_gdal();

}  // namespace thiessen
