#pragma once

#include <ogr_geometry.h>

#include <memory>

#include "gdal/geometry_record.h"
#include "geometry/polygon.h"

namespace thiessen {

/// The record of a geometry of GDAL's; curves are made straight lines.
GeometryRecord record_of(const OGRGeometry* geometry);

/// The same shape as GDAL has it; rings are closed.
std::unique_ptr<OGRMultiPolygon> ogr_shape(const MultiPolygon& shape);

/// Every polygon within a geometry of GDAL's, with closed rings opened.
MultiPolygon polygons_of(const OGRGeometry& geometry);

}  // namespace thiessen
