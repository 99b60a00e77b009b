#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// Whether RAINFALL consists of `.dly` files: its name ends so, or it is a folder.
bool is_dly(const std::string& rainfall);

/// Gives the file itself, or all `.dly` files of the folder in the order of their names. Throws
/// Error if there are none, or if the folder cannot be read.
std::vector<std::string> dly_files(const std::string& rainfall);

}  // namespace thiessen
