#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// Appends a text as a JSON string that is safe wherever JSON is pasted: besides quotes,
/// backslashes and control characters, it escapes `<` and the line ends U+2028 and U+2029. Bytes
/// that are not UTF-8 become U+FFFD.
void append_json_string(std::string& out, std::string_view text);

}  // namespace thiessen
