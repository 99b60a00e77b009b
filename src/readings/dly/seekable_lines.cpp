#include "readings/dly/seekable_lines.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr std::size_t piece_bytes = std::size_t{64} << 10;

}  // namespace

void SeekableLines::go(const std::string& file, LinePlace place) {
  if (!file_.is_open() || file != name_) open(file);
  next_line_ = place.line;
  if (place.offset >= origin_ && place.offset - origin_ <= buffer_.size()) {
    at_ = place.offset - origin_;
    return;
  }
  buffer_.clear();
  at_ = 0;
  origin_ = place.offset;
}

void SeekableLines::open(const std::string& file) {
  name_ = file;
  buffer_.clear();
  at_ = 0;
  origin_ = 0;
  file_ = open_descriptor(file, O_RDONLY | O_NONBLOCK);
  if (!file_.is_open()) throw system_error(file, "cannot open", errno);
  struct stat status = {};
  if (::fstat(file_.number(), &status) != 0) throw system_error(file, "cannot open", errno);
  if (!S_ISREG(status.st_mode)) {
    throw Error(Message{file, 0, "is no plain file, which can be read twice", ""});
  }
}

bool SeekableLines::read_more() {
  throw_if_interrupted();
  buffer_.erase(0, at_);
  origin_ += at_;
  at_ = 0;
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + piece_bytes);
  for (;;) {
    const ssize_t count = ::pread(file_.number(), buffer_.data() + kept, piece_bytes,
                                  static_cast<off_t>(origin_ + kept));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw system_error(name_, "cannot read", errno);
    buffer_.resize(kept + static_cast<std::size_t>(count));
    return count > 0;
  }
}

std::optional<std::string_view> SeekableLines::next() {
  std::size_t end = buffer_.find('\n', at_);
  while (end == std::string::npos && buffer_.size() - at_ <= longest_line) {
    const std::size_t looked_at = buffer_.size() - at_;
    if (!read_more()) break;
    end = buffer_.find('\n', looked_at);
  }
  place_ = {origin_ + at_, next_line_++};
  ends_ = end != std::string::npos;
  std::string_view line = std::string_view(buffer_).substr(at_);
  if (ends_) line = line.substr(0, end - at_);
  if (!ends_ && line.empty()) return std::nullopt;
  if (line.size() > longest_line) {
    throw Error(Message{
        name_, place_.line,
        "the line is longer than " + std::to_string(longest_line) + " bytes, the limit", ""});
  }
  at_ += line.size() + (ends_ ? 1 : 0);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace thiessen
