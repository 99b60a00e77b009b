#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "text/csv_dialect.h"
#include "text/csv_reader.h"

namespace thiessen {

/// Opens a CSV as a user names it: a file, `-`, a gzip of one, or one in an archive. How it is
/// written, beyond what the user says, is found out (see find_csv_form), and told in one notice
/// where that is not with commas, decimal points, in UTF-8 and with the header first. Throws Error,
/// see CsvReader and find_opening.
std::unique_ptr<CsvReader> open_csv(const std::string& file, const CsvDialect& said,
                                    const CsvLimits& limits, Warnings& warnings);

}  // namespace thiessen
