#pragma once

#include <memory>

#include "base/error.h"
#include "files/tables/source.h"
#include "text/table.h"

namespace thiessen {

/// Opens a sheet of a .xlsx or .ods as a table of texts (see SheetTable); null where the source is
/// none. Throws Error as find_opening and SheetTable do.
std::unique_ptr<Table> open_sheet(const Source& source, Warnings& warnings);

}  // namespace thiessen
