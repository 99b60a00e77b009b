#pragma once

#include <string>

class GDALDriver;

namespace thiessen {

/// The part of a path's file name after its last dot, in lower case; empty where there is no dot.
std::string extension_of(const std::string& path);

/// The driver of GDAL's that writes vectors to `path`. Throws Error, listing the known extensions,
/// where none does.
GDALDriver& require_vector_driver(const std::string& path);

}  // namespace thiessen
