#include "readings/published/published_format.h"

#include "base/utf8.h"
#include "text/field_names.h"

namespace thiessen {

namespace {

bool has_name_among(std::string_view column, const std::vector<std::string_view>& names) {
  for (std::string_view name : names) {
    if (same_name(column, name)) return true;
    if (!name.ends_with('*')) continue;
    name.remove_suffix(1);
    if (plain_name(column).starts_with(plain_name(name))) return true;
  }
  return false;
}

}  // namespace

bool has_published_name(std::string_view column, std::string_view names) {
  return has_name_among(column, parted(names, '|'));
}

std::optional<std::size_t> published_column(const std::vector<std::string>& header,
                                            std::string_view names) {
  const std::vector<std::string_view> any = parted(names, '|');
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (has_name_among(header[i], any)) return i;
  }
  return std::nullopt;
}

std::vector<std::string_view> parted(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace thiessen
