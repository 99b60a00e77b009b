#pragma once

#include <ogr_geometry.h>

#include <memory>
#include <optional>
#include <string>

#include "geometry/polygon.h"
#include "io/geometry_record.h"

namespace thiessen {

/// The record of a geometry of GDAL's; curves are made straight lines.
GeometryRecord record_of(const OGRGeometry* geometry);

/// The record of a WKT text; nothing where it is none.
std::optional<GeometryRecord> record_of_wkt(const std::string& wkt);

/// The same shape as GDAL has it; rings are closed.
std::unique_ptr<OGRMultiPolygon> ogr_shape(const MultiPolygon& shape);

/// Every polygon within a geometry of GDAL's, with closed rings opened.
MultiPolygon polygons_of(const OGRGeometry& geometry);

}  // namespace thiessen
