#pragma once

#include <string>

namespace thiessen {

/// The version of the GDAL that runs, such as "3.6.2".
std::string gdal_version();
/// The version of the PROJ that runs, such as "9.1.1".
std::string proj_version();

}  // namespace thiessen
