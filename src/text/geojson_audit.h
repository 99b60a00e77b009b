#pragma once

#include <cstddef>
#include <string>

#include "text/byte_source.h"

namespace thiessen {

/// What the text of a GeoJSON file says that GDAL keeps to itself.
struct GeoJsonFindings {
  enum class CrsMember { absent, null, name, link, other };
  CrsMember crs = CrsMember::absent;
  std::string crs_name;      ///< where the member is a name
  std::size_t features = 0;  ///< of a FeatureCollection, else 1
};

/// Reads a GeoJSON file from end to end and proves it one whole JSON text whose coordinates are
/// finite numbers, nested as their geometry's type wants. GDAL takes NaN, infinite and missing
/// coordinates, and text after the end, without a word. Throws Error with the line, or with the
/// path
/// (`features[3].geometry.coordinates[0][2]`) of each bad coordinate.
/// `file` is the name that messages give it.
/// Cost: one pass; memory bounded by the keys of one object, whatever the file's length.
GeoJsonFindings audit_geojson(const std::string& file, ByteSource& source);

}  // namespace thiessen
