#pragma once

#include <optional>
#include <string>

#include "gdal/layers/geometry_record.h"

namespace thiessen {

/// The geometry record of a WKT text; empty where the text is not WKT.
std::optional<GeometryRecord> record_of_wkt(const std::string& wkt);

}  // namespace thiessen
