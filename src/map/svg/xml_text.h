#pragma once

#include <string>
#include <string_view>

#include "map/ink/canvas.h"

namespace thiessen {

/// The text as it stands in XML, between tags or between double quotes. Characters that XML 1.0
/// does not allow, and bytes that are not UTF-8, become U+FFFD. Cost: the text.
std::string xml_text(std::string_view utf8);

/// The colour as XML's relatives write it, such as "#ff8000".
std::string hexadecimal(Colour colour);

}  // namespace thiessen
