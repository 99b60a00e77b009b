#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// Appends a field to a row of CSV. It is put in quotes where RFC 4180 requires them: where it has
/// commas, quotes, line ends, or blanks at an end. So is one that begins with a byte order mark,
/// which readers drop at the beginning of a file.
void append_csv_field(std::string& row, std::string_view field);

}  // namespace thiessen
