#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace thiessen::cli {

/// The words as the program shows them: a setting becomes an option (`--time-field`,
/// `--missing=-99`), an input an argument (`STATIONS`), and control characters are shown as \x1b.
std::string shown(const Wording& words);

/// Prints on the standard error: `before` (such as `thiessen: error: `) and the message on one
/// line, and the hint on another.
void print(std::string_view before, const Message& message);
/// Prints a text and a hint, which have to be fit for the terminal as they are, in the form of a
/// message.
void print(std::string_view before, const std::string& text, const std::string& hint);

/// Prints a hint alone, after a message that has been printed.
void print_hint(const std::string& hint);

/// Prints all messages of an error, and how many more there were.
void print(std::string_view before, const Error& error);

/// Prints that memory is lacking, and what for, which takes none.
void print_lack_of_memory(std::string_view what = {}) noexcept;

/// Prints as an error what was noted before something broke off (base/last_words). Takes no memory.
void print_last_words(std::string_view words) noexcept;

/// Prints notices and warnings, which are then forgotten.
void print(Warnings& warnings);

}  // namespace thiessen::cli
