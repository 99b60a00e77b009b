#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"

namespace thiessen {

/// Whether texts in this encoding can be read. Case does not count, nor do hyphens, blanks and
/// underscores: Latin-1, cp932, Windows-1252 and whatever else iconv of this machine knows.
bool is_encoding(const std::string& name);

/// A text of another encoding as UTF-8, up to the first byte that is not of it. Throws Error where
/// is_encoding is false.
std::string decoded(std::string_view text, const std::string& encoding);

/// Reads a file that is written in another encoding than UTF-8, by iconv.
class Decoder {
 public:
  /// Throws Error where is_encoding is false. `begun` holds bytes of the file that have been read.
  explicit Decoder(std::string encoding, std::string_view begun = {});

  const std::string& encoding() const { return encoding_; }
  /// Reads what comes next into the beginning of `into`, as UTF-8, and returns how many bytes that
  /// is; 0 at the end, and before the first byte that is not of the encoding: see fault. Requires
  /// room for one character, of four bytes.
  std::size_t read(InputFile& from, std::span<char> into);
  /// Whether it holds bytes of the file that have only to be converted.
  bool holds_more() const { return holds_more_; }
  /// The place of the first byte that is not of the encoding, from 0 in the file; nothing where
  /// none was met.
  std::optional<std::size_t> fault() const { return fault_; }

 private:
  struct Close {
    void operator()(void* conversion) const;
  };

  bool read_more(InputFile& from);
  std::size_t convert(std::span<char> into);

  std::string encoding_;
  std::unique_ptr<void, Close> conversion_;
  std::vector<char> raw_;
  std::size_t begin_ = 0;  ///< where what is not yet converted lies in raw_
  std::size_t end_ = 0;
  std::size_t origin_ = 0;  ///< where in the file raw_ begins
  bool at_end_ = false;
  bool flushed_ = false;
  bool holds_more_ = false;
  std::optional<std::size_t> fault_;
};

}  // namespace thiessen
