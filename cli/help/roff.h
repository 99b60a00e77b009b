#pragma once

#include <string>
#include <string_view>

namespace thiessen::cli {

/// Text as man(7) wants it: what would be a command to the formatter is escaped.

/// A phrase within a line: backslashes are escaped, and dashes are minus signs, as they have to be
/// typed.
std::string roff_phrase(std::string_view text);
std::string roff_bold(std::string_view text);
std::string roff_italic(std::string_view text);
/// A paragraph, in lines of at most 80 characters where a word allows it, each ended.
std::string roff_paragraph(std::string_view text);
/// Lines as they are, in a fixed width.
std::string roff_verbatim(std::string_view lines);

}  // namespace thiessen::cli
