#pragma once

#include <string>

namespace thiessen::cli {

/// The manual's sections on files in and out, in the language of man(7): CSV, other files, feeds,
/// databases, what models read, times, units, the names of fields, and published formats.
std::string files_sections();

}  // namespace thiessen::cli
