#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace thiessen {

/// The files that RAINFALL stands for, in the order in which they are named: each folder that holds
/// no `.dly` file is replaced by its files of a format that is read, by its extension, in the order
/// of their names. A folder of `.dly` files stands for itself. What else lies in a folder is passed
/// over with a notice that names it, and its hidden files in silence; so is a text that is surely
/// no table, such as a readme.txt: without a row of as many fields as its first. Throws Error where
/// a folder cannot be read, or holds no such file.
std::vector<std::string> rainfall_files(const std::vector<std::string>& named, Warnings& warnings);

}  // namespace thiessen
