#include "text/text_lines.h"

#include <algorithm>
#include <limits>
#include <span>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen {

std::optional<std::string_view> TextLines::next() {
  std::size_t end = buffer_.find('\n', at_);
  for (std::size_t seen = buffer_.size(); end == std::string::npos; seen = buffer_.size()) {
    const std::size_t before = at_;
    if (!read_more()) break;
    end = buffer_.find('\n', seen - before);
  }
  if (end == std::string::npos) {
    if (at_ == buffer_.size()) return std::nullopt;
    end = buffer_.size();
  }
  std::string_view line(buffer_.data() + at_, end - at_);
  at_ = end < buffer_.size() ? end + 1 : end;
  if (++line_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

double TextLines::share_read() const {
  if (input_.size() == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(read_ - (buffer_.size() - at_)) / static_cast<double>(input_.size());
}

/// Reads what comes next behind what is left of the buffer.
bool TextLines::read_more() {
  constexpr std::size_t block = std::size_t{64} << 10;
  if (buffer_.size() - at_ > longest_line) {
    throw Error({file(), line_ + 1,
                 "the line is longer than " + std::to_string(longest_line) + " bytes", ""});
  }
  buffer_.erase(0, at_);
  at_ = 0;
  const std::size_t held = buffer_.size();
  buffer_.resize(held + block);
  const std::size_t count = input_.read(std::span<char>(buffer_).subspan(held));
  buffer_.resize(held + count);
  read_ += count;
  return count > 0;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace thiessen
