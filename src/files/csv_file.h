#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "text/csv_reader.h"

namespace thiessen {

/// Opens a CSV as a user names it: a file, `-`, a gzip of one, or one in an archive. What is
/// found out to part the fields is told, as a notice, where it is no comma. Throws Error, see
/// CsvReader and find_opening.
std::unique_ptr<CsvReader> open_csv(const std::string& file, const CsvOptions& options,
                                    Warnings& warnings);

}  // namespace thiessen
