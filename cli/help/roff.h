#pragma once

#include <string>
#include <string_view>

namespace thiessen::cli {

/// \file
/// Text in the language of man(7): anything in it that would be a command to the formatter is
/// escaped.

/// A text as a sentence: it begins with a capital, of A to Z, and ends in a full stop. Requires a
/// text. Nothing is escaped.
std::string as_sentence(std::string text);

/// A phrase within a line. Backslashes are escaped, and dashes become minus signs, so that what is
/// copied from the page can be typed.
std::string roff_phrase(std::string_view text);
std::string roff_bold(std::string_view text);
std::string roff_italic(std::string_view text);
/// A paragraph in lines of at most 80 characters where a word allows it, each with its line end.
std::string roff_paragraph(std::string_view text);
/// Lines as they are, in a font of fixed width.
std::string roff_verbatim(std::string_view lines);

}  // namespace thiessen::cli
