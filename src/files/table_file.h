#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "text/csv_dialect.h"
#include "text/table.h"

namespace thiessen {

/// Opens a table without geometry, such as RAINFALL: a CSV (`-` is the standard input), or a layer
/// of anything that GDAL reads. What is found out of a CSV beyond what the user says (see
/// open_csv), and what GDAL warns of, goes to `warnings`, which must live until the last row is
/// read. Throws Error, see CsvReader and Layer.
std::unique_ptr<Table> open_table(const std::string& file, const CsvDialect& said,
                                  Warnings& warnings);

}  // namespace thiessen
