#pragma once

#include <string>

namespace thiessen {

/// Throws Error where a NetCDF of the classic formats is shorter than its header says: the library
/// reads zeros where its bytes are not there. Of NetCDF-4 the library itself tells. Cost: that of
/// the header.
void require_whole_netcdf(const std::string& file);

}  // namespace thiessen
