#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace thiessen::cli {

/// The words as the program shows them: a setting is an option (`--time-field`, `--missing=-99`),
/// an input an argument (`STATIONS`); control characters are shown as \x1b.
std::string shown(const Wording& words);

/// Prints on the standard error: what stands before it (`thiessen: error: `), the message on a line
/// and its hint on another.
void print(std::string_view before, const Message& message);
/// The same of a text and a hint that may be shown as they are.
void print(std::string_view before, const std::string& text, const std::string& hint);

/// All of an error's messages, and how many more there were.
void print(std::string_view before, const Error& error);

}  // namespace thiessen::cli
