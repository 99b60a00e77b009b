#include "gdal/output/compact_xml.h"

#include <algorithm>

namespace thiessen {

std::string compact_xml(std::string_view xml) {
  std::string compact;
  compact.reserve(xml.size());
  bool after_opening = false;  // whether the last tag began an element
  for (std::size_t i = 0; i < xml.size();) {
    const std::size_t tag = std::min(xml.find('<', i), xml.size());
    const std::string_view text = xml.substr(i, tag - i);
    const bool is_blank = text.find_first_not_of(" \t\r\n") == std::string_view::npos;
    const bool is_content = after_opening && xml.substr(tag).starts_with("</");
    if (!is_blank || is_content) compact += text;
    const std::size_t end = std::min(xml.find('>', tag), xml.size() - 1) + 1;
    const std::string_view found = xml.substr(tag, std::max(end, tag) - tag);
    after_opening = !found.starts_with("</") && !found.starts_with("<?") && !found.ends_with("/>");
    compact += found;
    i = std::max(end, tag);
  }
  return compact;
}

}  // namespace thiessen
