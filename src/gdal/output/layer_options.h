#pragma once

#include <string>

#include "gdal/output/vector_layer.h"

class CPLStringList;

namespace thiessen {

/// The options with which a driver creates the file of a layer.
CPLStringList file_options(const VectorLayer& layer, const std::string& driver);

/// The options with which it creates the layer itself: nothing depends on the day, names and texts
/// stay as they are, and what it says of how it was made stands where the format has a place for
/// it. Throws Error, naming `path`, where the format keeps a field's name for itself.
CPLStringList layer_options(const VectorLayer& layer, const std::string& driver, bool has_crs,
                            const std::string& path);

}  // namespace thiessen
