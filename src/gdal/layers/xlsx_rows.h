#pragma once

#include <memory>
#include <string>

#include "gdal/layers/sheet_rows.h"
#include "gdal/layers/xlsx_book.h"

namespace thiessen {

/// The rows of a sheet of a .xlsx file. The book must outlive them. Throws Error where the sheet
/// cannot be opened.
std::unique_ptr<SheetRows> xlsx_rows(const std::string& file, const XlsxBook& book,
                                     const XlsxBook::Sheet& sheet);

}  // namespace thiessen
