#pragma once

#include <string>

class GDALDriver;

namespace thiessen {

/// The part of a path's file name after its last dot, in lower case; empty where there is no dot.
std::string extension_of(const std::string& path);

/// Whether a format of this extension can hold longitude and latitude and no other coordinates.
bool holds_degrees_only(const std::string& extension);

/// Throws Error where such a format is to hold coordinates whose CRS is not known.
void require_known_degrees(const std::string& path, bool has_crs);

/// The driver of GDAL's that writes vectors to `path`. Throws Error, listing the known extensions,
/// where none does.
GDALDriver& require_vector_driver(const std::string& path);

}  // namespace thiessen
