#pragma once

#include <optional>
#include <string>

#include "gdal/geometry_record.h"

namespace thiessen {

/// The record of a WKT text; nothing where it is none.
std::optional<GeometryRecord> record_of_wkt(const std::string& wkt);

}  // namespace thiessen
