#pragma once

#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "text/csv_structure.h"
#include "text/decoder.h"

namespace thiessen {

/// Counts line ends as an editor does: LF, CRLF and CR each end one line.
std::size_t count_line_ends(std::string_view text);

/// The text of a CSV file, of which a window is in memory. It is checked to be UTF-8 without NUL,
/// and scanned for the characters that can end a field. Places are byte offsets in the file, from
/// 0; where the file is written in another encoding, in its text as UTF-8.
class CsvText {
 public:
  /// An empty `encoding` is UTF-8, or UTF-16 where the file begins with the mark of that.
  CsvText(InputFile input, char separator, const std::string& encoding = {});

  const std::string& name() const { return input_.name(); }
  /// The size of the file in bytes; 0 where it is not known.
  std::size_t size() const { return input_.size(); }
  bool may_wait() const { return input_.may_wait(); }
  /// Whether more of the file is there, or comes within `patience`: see InputFile.
  bool has_bytes(std::chrono::milliseconds patience) {
    return at_end_ || (decoder_ && decoder_->holds_more()) || input_.has_bytes(patience);
  }
  bool is_at_end() const { return at_end_; }
  /// The encoding of the file; empty for UTF-8.
  std::string encoding() const { return decoder_ ? decoder_->encoding() : std::string(); }
  /// The place at which the window ends. The file may go on: see read_more.
  std::size_t end() const { return origin_ + filled_; }
  const char* pointer(std::size_t at) const { return buffer_.data() + (at - origin_); }
  char* pointer(std::size_t at) { return buffer_.data() + (at - origin_); }
  char at(std::size_t place) const { return *pointer(place); }
  std::string_view between(std::size_t from, std::size_t to) const {
    return {pointer(from), to - from};
  }

  enum class Arrival : std::uint8_t { more, end, nul, not_utf8, not_decoded };
  /// Reads more of the file into the window, and drops what lies before `keep_from`. Pointers may
  /// move: compare `pointer(keep_from)` before and after. The window grows to at most twice what is
  /// kept.
  Arrival read_more(std::size_t keep_from);
  /// The place of the first byte that is NUL, not UTF-8, or not of the file's encoding, after
  /// read_more has reported one; of the last in the file itself.
  std::size_t fault() const { return fault_; }

  /// Changes what parts fields; seek has to be called after it.
  void set_separator(char separator) { separator_ = separator; }
  /// Starts scanning at this place. It must be called again after read_more.
  void seek(std::size_t at);
  /// The place of the next separator, quote, LF or CR, or end() where the window has no more of
  /// them.
  std::size_t next_mark() {
    while (marks_ == 0) {
      block_ += csv_block;
      if (block_ >= filled_) return end();
      look();
    }
    const std::size_t at = block_ + static_cast<std::size_t>(std::countr_zero(marks_));
    marks_ &= marks_ - 1;
    return origin_ + at;
  }

 private:
  void look();
  std::size_t read_bytes(std::span<char> into);
  void make_room(std::size_t keep_from);
  Arrival check(bool last);

  InputFile input_;
  std::optional<Decoder> decoder_;
  char separator_;
  /// The window, one block longer than its contents may be, so that scanning may overshoot.
  std::vector<char> buffer_;
  std::size_t origin_ = 0;   ///< where in the file the buffer begins
  std::size_t filled_ = 0;   ///< bytes in the buffer; the next three count from its beginning
  std::size_t checked_ = 0;  ///< how many bytes are known to be valid
  std::size_t block_ = 0;    ///< the start of the 64 bytes that are being scanned
  std::uint64_t marks_ = 0;  ///< the marks in that block that are not yet returned, a bit each
  std::size_t fault_ = 0;
  bool begun_ = false;
  bool at_end_ = false;
};

}  // namespace thiessen
