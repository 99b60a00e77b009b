#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "gdal/layers/sheet_rows.h"

namespace thiessen {

/// The names of the sheets of a .ods file, whose content.xml is given as GDAL is given it. Throws
/// Error where it is not whole.
std::vector<std::string> ods_sheets(const std::string& file, const std::string& document);

/// The rows of a sheet of a .ods file, counted from 0 (OpenDocument 1.3, part 3, chapter 9). A row
/// or a cell that is written once and repeated comes as often as that. Remarks on cells are no part
/// of them. Throws Error where the document cannot be opened.
std::unique_ptr<SheetRows> ods_rows(const std::string& file, const std::string& document,
                                    std::size_t sheet);

}  // namespace thiessen
