#pragma once

#include <cstddef>
#include <string>

#include "text/byte_source.h"

namespace thiessen {

/// What the text of a GeoJSON file says that GDAL does not report.
struct GeoJsonFindings {
  enum class CrsMember { absent, null, name, link, other };
  CrsMember crs = CrsMember::absent;
  std::string crs_name;      ///< the name, where the member is one
  std::size_t features = 0;  ///< the number in a FeatureCollection, otherwise 1
};

/// Reads a whole GeoJSON file, and proves that it is one complete JSON text whose coordinates are
/// finite numbers, nested as the type of their geometry requires. This is necessary because GDAL
/// silently accepts NaN, infinite and missing coordinates, and text after the end. `file` is the
/// name of the file in messages.
/// Throws Error with the line, or with the path (`features[3].geometry.coordinates[0][2]`) of each
/// bad coordinate.
/// Cost: one pass; memory is bounded by the keys of one object, whatever the file's length.
GeoJsonFindings audit_geojson(const std::string& file, ByteSource& source);

}  // namespace thiessen
