#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "text/csv_structure.h"

namespace thiessen {

/// The text of a CSV file, a window of it at a time, checked to be UTF-8 without NUL, and scanned
/// for the characters that can end a field. Places are byte offsets in the file, from 0.
class CsvText {
 public:
  CsvText(InputFile input, char separator);

  const std::string& name() const { return input_.name(); }
  /// The file's, in bytes; 0 where it is not known.
  std::size_t size() const { return input_.size(); }
  /// Where the window ends; the file goes on if `read_more` says so.
  std::size_t end() const { return origin_ + filled_; }
  const char* pointer(std::size_t at) const { return buffer_.data() + (at - origin_); }
  char* pointer(std::size_t at) { return buffer_.data() + (at - origin_); }
  char at(std::size_t place) const { return *pointer(place); }
  std::string_view between(std::size_t from, std::size_t to) const {
    return {pointer(from), to - from};
  }

  enum class Arrival : std::uint8_t { more, end, nul, not_utf8 };
  /// Moves the window's end on; what lies before `keep_from` goes. Pointers may move: compare
  /// `pointer(keep_from)` before and after. The window grows to twice what is kept at most.
  Arrival read_more(std::size_t keep_from);
  /// The first byte that is NUL or no UTF-8, after read_more has said so.
  std::size_t fault() const { return fault_; }

  /// Scans from here on. Needed again after read_more.
  void seek(std::size_t at);
  /// The next separator, quote, LF or CR; end() where the window has no more of them.
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
  void make_room(std::size_t keep_from);
  Arrival check(bool last);

  InputFile input_;
  char separator_;
  std::vector<char>
      buffer_;  ///< a block longer than what it may hold, so that scanning may overshoot
  std::size_t origin_ = 0;   ///< where in the file the buffer begins
  std::size_t filled_ = 0;   ///< bytes in the buffer, as all that follow
  std::size_t checked_ = 0;  ///< bytes known to be good
  std::size_t block_ = 0;    ///< the 64 bytes that are being scanned
  std::uint64_t marks_ = 0;  ///< in that block, those not yet met
  std::size_t fault_ = 0;
  bool at_end_ = false;
};

}  // namespace thiessen
