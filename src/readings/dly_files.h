#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// Whether RAINFALL is `.dly` files: a name that ends so, or a folder.
bool is_dly(const std::string& rainfall);

/// The file itself, or all `.dly` files of the folder in the order of their names. Throws Error
/// where there are none, or the folder cannot be read.
std::vector<std::string> dly_files(const std::string& rainfall);

}  // namespace thiessen
