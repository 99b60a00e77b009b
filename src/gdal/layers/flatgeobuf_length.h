#pragma once

#include <string>

namespace thiessen {

/// Requires a FlatGeobuf to hold as many whole features as its header declares, and to end with the
/// last of them. GDAL reads what is there, in silence. `name` is the file as GDAL is given it,
/// `file` as messages name it. Throws Error with both numbers. Cost: reads the header and four
/// bytes of each feature.
void require_whole_flatgeobuf(const std::string& file, const std::string& name);

}  // namespace thiessen
