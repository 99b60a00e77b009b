#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// An XML document without the blanks and line ends that only lay it out: those between two tags,
/// unless they are all that an element holds.
std::string compact_xml(std::string_view xml);

}  // namespace thiessen
