#pragma once

#include <cstddef>
#include <string>

#include "base/file.h"

namespace thiessen {

/// Opens a text as a user names it: a file, `-`, a gzip of one, or one in an archive. Throws Error,
/// see find_opening.
InputFile open_text(const std::string& file);

/// The first bytes of a text that can be read more than once, at most so many; empty of one that
/// cannot, that is no text, or that cannot be opened: whoever reads it says so.
std::string beginning_of_text(const std::string& file, std::size_t bytes);

}  // namespace thiessen
