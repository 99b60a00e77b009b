#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// Appends a field as it is, in quotes where RFC 4180 wants them: commas, quotes, line ends, and
/// blanks at an end.
void append_csv_field(std::string& row, std::string_view field);

}  // namespace thiessen
