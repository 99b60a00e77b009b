#include "text/csv_text.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "base/utf8.h"

namespace thiessen {
namespace {

/// The window is small enough to stay in the second-level cache between reading, checking and
/// scanning.
constexpr std::size_t window_bytes = std::size_t{256} << 10;

/// Whether this is UTF-8 and needs no decoder.
bool is_utf8(const std::string& encoding) {
  return encoding.empty() || equal_ignoring_case(encoding, "UTF-8") ||
         equal_ignoring_case(encoding, "UTF8");
}

bool has_mark_of_utf16(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

}  // namespace

std::size_t count_line_ends(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool inside_crlf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if ((text[i] == '\n' || text[i] == '\r') && !inside_crlf) ++count;
  }
  return count;
}

CsvText::CsvText(InputFile input, char separator, const std::string& encoding)
    : input_(std::move(input)),
      separator_(separator),
      buffer_(window_bytes + csv_block),
      begun_(!encoding.empty()) {
  if (!is_utf8(encoding)) decoder_.emplace(encoding);
}

CsvText::Arrival CsvText::read_more(std::size_t keep_from) {
  if (at_end_) return Arrival::end;
  make_room(keep_from);
  const std::size_t room = buffer_.size() - csv_block - filled_;
  const std::size_t count = read_bytes(std::span(buffer_).subspan(filled_, room));
  filled_ += count;
  at_end_ = count == 0;
  if (at_end_ && decoder_ && decoder_->fault()) {
    fault_ = *decoder_->fault();
    return Arrival::not_decoded;
  }
  const Arrival arrival = check(at_end_);
  return arrival == Arrival::more && at_end_ ? Arrival::end : arrival;
}

std::size_t CsvText::read_bytes(std::span<char> into) {
  if (decoder_) return decoder_->read(input_, into);
  std::size_t count = input_.read(into);
  if (std::exchange(begun_, true)) return count;
  while (count == 1) {  // half a mark, perhaps
    const std::size_t more = input_.read(into.subspan(count));
    if (more == 0) return count;
    count += more;
  }
  const std::string_view bytes(into.data(), count);
  if (!has_mark_of_utf16(bytes)) return count;
  decoder_.emplace("UTF-16", bytes);
  return decoder_->read(input_, into);
}

void CsvText::make_room(std::size_t keep_from) {
  const std::size_t capacity = buffer_.size() - csv_block;
  if (capacity - filled_ >= capacity / 2) return;
  const std::size_t spent = keep_from - origin_;
  if (spent > 0) std::memmove(buffer_.data(), buffer_.data() + spent, filled_ - spent);
  origin_ += spent;
  filled_ -= spent;
  checked_ -= spent;
  if (filled_ > capacity / 2) buffer_.resize(2 * capacity + csv_block);
}

CsvText::Arrival CsvText::check(bool last) {
  const std::string_view fresh(buffer_.data() + checked_, filled_ - checked_);
  const Utf8Prefix prefix = valid_utf8_prefix(fresh);
  const std::size_t nul = fresh.substr(0, prefix.valid).find('\0');
  fault_ = origin_ + checked_ + std::min(nul, prefix.valid);
  if (nul != std::string_view::npos) return Arrival::nul;
  checked_ += prefix.valid;
  const bool whole = checked_ == filled_ || (prefix.truncated && !last);
  return whole ? Arrival::more : Arrival::not_utf8;
}

void CsvText::seek(std::size_t at) {
  block_ = at - origin_;
  marks_ = 0;
  if (block_ < filled_) look();
}

void CsvText::look() {
  marks_ = csv_structure(buffer_.data() + block_, separator_);
  const std::size_t left = filled_ - block_;
  if (left < csv_block) marks_ &= (std::uint64_t{1} << left) - 1;
}

}  // namespace thiessen
