#pragma once

#include <memory>
#include <string>

#include "text/table.h"

namespace thiessen {

/// Opens a table that has no geometry to it, such as RAINFALL: a CSV (`-`: the standard input), or
/// a layer of anything that GDAL reads. `separator` '\0': a comma. Throws Error, see CsvReader and
/// Layer.
std::unique_ptr<Table> open_table(const std::string& file, char separator);

}  // namespace thiessen
