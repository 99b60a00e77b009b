#pragma once

namespace thiessen {

/// Starts GDAL, once, with only the drivers that are promised (GeoJSON, GeoPackage, Shapefile,
/// FlatGeobuf, KML, spreadsheets, PostGIS). Nothing is fetched over a network, and the user's
/// environment has no effect, because variables of GDAL's and PROJ's own options are removed from
/// it. Call it before threads start, since the environment is changed.
void start_gdal();

}  // namespace thiessen
