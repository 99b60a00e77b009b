#include "text/last_line.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

namespace thiessen {

bool ends_within_line(const std::string& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return false;
  constexpr std::streamoff looked_at = 2;  // in UTF-16 an end has a byte of zeros behind it
  std::ifstream text(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = text.tellg();
  if (size <= 0) return false;
  std::array<char, 4> first{};
  text.seekg(0);
  text.read(first.data(), std::ssize(first));
  text.clear();
  const std::string_view begin(first.data(), first.size());
  if (begin == "PK\x03\x04" || begin.starts_with("\x1f\x8b")) return false;
  std::array<char, looked_at> last{};
  text.seekg(size - std::min(size, looked_at));
  text.read(last.data(), std::min(size, looked_at));
  const std::string_view end(last.data(), static_cast<std::size_t>(text.gcount()));
  if (end.ends_with('\n') || end.ends_with('\r')) return false;
  return end != std::string_view("\n\0", 2) && end != std::string_view("\r\0", 2);
}

void tell_of_last_line(const std::string& file, Warnings& warnings) {
  if (ends_within_line(file)) warnings.add_notice({file, 0, last_line_has_no_end, {}});
}

}  // namespace thiessen
