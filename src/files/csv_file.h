#pragma once

#include <memory>
#include <string>

#include "base/error.h"
#include "text/csv_reader.h"

namespace thiessen {

/// Opens a CSV as a user names it: a file, `-`, a gzip of one, or one in an archive. Throws Error,
/// see CsvReader and find_opening.
std::unique_ptr<CsvReader> open_csv(const std::string& file, const CsvOptions& options);

/// Tells, as a notice, what parts the fields where that was found out and is no comma.
void tell_separator(const CsvReader& csv, Warnings& warnings);

}  // namespace thiessen
