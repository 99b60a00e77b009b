#include "cli/session/script_lines.h"

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen::cli {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::size_t chunk = std::size_t{64} << 10;

}  // namespace

std::optional<std::string_view> ScriptLines::next(const std::function<void()>& before_waiting) {
  std::size_t searched = at_;
  for (;;) {
    if (after_return_ && at_ < buffer_.size()) {
      if (buffer_[at_] == '\n') searched = ++at_;
      after_return_ = false;
    }
    const std::size_t end = buffer_.find_first_of("\r\n", searched);
    if (end != std::string::npos) {
      after_return_ = buffer_[end] == '\r';
      return take(end, end + 1);
    }
    if (buffer_.size() - at_ > longest_line) return take(buffer_.size(), buffer_.size());
    const std::size_t unread = buffer_.size() - at_;
    before_waiting();
    if (read_more()) {
      searched = at_ + unread;
    } else if (unread > 0) {
      return take(buffer_.size(), buffer_.size());
    } else {
      return std::nullopt;
    }
  }
}

bool ScriptLines::read_more() {
  origin_ += at_;
  buffer_.erase(0, at_);
  at_ = 0;
  const std::size_t before = buffer_.size();
  buffer_.resize(before + chunk);
  const std::size_t count = input_.read({buffer_.data() + before, chunk});
  buffer_.resize(before + count);
  return count > 0;
}

std::string_view ScriptLines::take(std::size_t end, std::size_t next) {
  ++line_;
  const std::string_view text = std::string_view(buffer_).substr(at_, end - at_);
  check(text);
  const bool has_mark = line_ == 1 && text.starts_with(byte_order_mark);
  at_ = next;
  return text.substr(has_mark ? byte_order_mark.size() : 0);
}

void ScriptLines::check(std::string_view text) const {
  const auto fail = [&](const std::string& fault, std::size_t place, const std::string& hint) {
    throw Error(Message{file(), line_, fault + std::to_string(origin_ + at_ + place), hint});
  };
  if (text.size() > longest_line) {
    throw Error(
        Message{file(),
                line_,
                "the line is longer than " + std::to_string(longest_line) + " bytes, the limit",
                {}});
  }
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
    fail("not text: NUL at byte ", nul, "is this a text file in UTF-8?");
  if (const auto invalid = find_invalid_utf8(text))
    fail("not UTF-8 at byte ", *invalid, "save the file as UTF-8");
}

}  // namespace thiessen::cli
