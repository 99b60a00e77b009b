#pragma once

#include <ogr_spatialref.h>

#include <string>

namespace thiessen {

/// Whether the system is on a sphere: a model's Earth (WRF, MODIS, EASE-Grid).
bool is_on_sphere(const OGRSpatialReference& system);

/// The system, whose definition in WKT 2 is `wkt`, without the shift to WGS 84 that is written
/// beside it (TOWGS84, +towgs84, BOUNDCRS). A model's longitudes and latitudes come from those of
/// WGS 84, unchanged; tools write a shift of zeros for any datum that they do not know, and from a
/// sphere that moves latitudes by up to 21 km.
OGRSpatialReference without_shift(const OGRSpatialReference& system, const std::string& wkt);

}  // namespace thiessen
