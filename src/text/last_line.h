#pragma once

#include <string>

#include "base/error.h"

namespace thiessen {

/// Whether a text on the disk ends within a line, as one does that is cut off: its last number may
/// have lost digits, and nothing in it tells. False of pipes, of archives and of empty files.
bool ends_within_line(const std::string& file);

/// What is then said of it.
inline constexpr const char* last_line_has_no_end =
    "its last line has no end, so that it may be cut off";

/// Adds a notice of it where that is so.
void tell_of_last_line(const std::string& file, Warnings& warnings);

}  // namespace thiessen
