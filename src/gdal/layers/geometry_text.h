#pragma once

#include <optional>
#include <string>

#include "gdal/layers/geometry_record.h"

namespace thiessen {

/// A geometry that a table holds as text.
struct GeometryText {
  GeometryRecord geometry;
  int srid = 0;  ///< the EPSG code that stands with it, as PostGIS writes it; 0: none does
};

/// Reads a geometry from a text: WKT, PostGIS's EWKT (`SRID=4326;POINT (1 2)`), and WKB in
/// hexadecimal digits, which is what PostGIS prints of a geometry, with its SRID or without.
/// Nothing where the text is anything else.
std::optional<GeometryText> geometry_of_text(const std::string& text);

}  // namespace thiessen
