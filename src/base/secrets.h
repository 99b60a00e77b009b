#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// A file's name without its password, where it is a connection: instead of what follows
/// `password=`, up to the next `word=`, and of what stands between `:` and `@` behind `://name`,
/// there is `***`. A password may have blanks that its user forgot to quote.
std::string without_password(std::string_view connection);

/// A sentence without the passwords of connections in it, each of which ends at a blank unless it
/// is quoted. Whatever is printed goes through it.
std::string without_passwords(std::string_view sentence);

/// The text of a library that was given the connection, without its password wherever the library
/// repeats it, as a whole or word by word.
std::string without_secrets(std::string text, std::string_view connection);

}  // namespace thiessen
