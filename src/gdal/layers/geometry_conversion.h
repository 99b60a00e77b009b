#pragma once

#include <ogr_geometry.h>

#include <memory>

#include "gdal/layers/geometry_record.h"
#include "geometry/polygon.h"

namespace thiessen {

/// The record of a geometry of GDAL's; curves become straight lines.
GeometryRecord record_of(const OGRGeometry* geometry);

/// A shape as a geometry of GDAL's, with closed rings.
std::unique_ptr<OGRMultiPolygon> ogr_shape(const MultiPolygon& shape);

/// Every polygon within a geometry of GDAL's, as rings that do not repeat the last point.
MultiPolygon polygons_of(const OGRGeometry& geometry);

}  // namespace thiessen
