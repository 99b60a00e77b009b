#pragma once

#include <memory>

#include "base/error.h"
#include "files/tables/source.h"
#include "text/table.h"

namespace thiessen {

/// Opens a table without geometry, such as RAINFALL: a CSV (`-` is the standard input), or a sheet
/// of a .xlsx or .ods (see SheetTable), a layer of anything else that GDAL reads; of its rows those
/// that the source's filter keeps (see FilteredTable). What is found out of a CSV beyond what the
/// user says (see open_csv), and what GDAL warns of, goes to `warnings`, which must live until the
/// last row is read. Throws Error, see CsvReader and Layer.
std::unique_ptr<Table> open_table(const Source& source, Warnings& warnings);

}  // namespace thiessen
