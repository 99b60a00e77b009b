#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// The files beside `path` that programs take for parts of it, by its format: those that are not
/// written anew are removed with the older output, whose index, CRS or table of attributes they
/// hold.
std::vector<std::string> side_files_of(const std::string& path);

}  // namespace thiessen
