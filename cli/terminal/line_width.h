#pragma once

#include <cstddef>

namespace thiessen::cli {

/// The characters in a line of the standard output: the terminal's, or 80 where it is none or does
/// not tell.
std::size_t line_width();

}  // namespace thiessen::cli
