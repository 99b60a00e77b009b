#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace thiessen {

/// The files that RAINFALL stands for, in the order in which they are named: each folder that holds
/// no `.dly` file is replaced by its files of a format that is read, by its extension, in the order
/// of their names. A folder of `.dly` files stands for itself. Of files that one of SWAT+'s or
/// ArcSWAT's lists names, in the same folder, the list stands for all.
///
/// What else lies in a folder is passed over with a notice that names it, and its hidden files in
/// silence: other kinds of files; a text that is surely no table, such as a readme.txt; folders in
/// it. The files `beside`, from which stations and basins are read, are left out of a folder with a
/// notice, unless they are surely tables of readings too. Files are compared by where they really
/// are, so that a link to one is that one.
///
/// Throws Error where a folder cannot be read, holds no such file, or holds several lists of which
/// it cannot be told which is that of rain.
std::vector<std::string> rainfall_files(const std::vector<std::string>& named,
                                        const std::vector<std::string>& beside, Warnings& warnings);

}  // namespace thiessen
