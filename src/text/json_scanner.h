#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "text/byte_source.h"

namespace thiessen {

/// Splits the text of a JSON file (RFC 8259, UTF-8) into its tokens, in memory that does not grow
/// with the file. Throws Error with the line at the first byte that is not JSON.
class JsonScanner {
 public:
  enum class Kind { object, array, string, number, literal, end };

  /// Scans the text of `source`, which must outlive the scanner. `file` is the name of the text in
  /// messages.
  JsonScanner(std::string file, ByteSource& source);
  ~JsonScanner();

  /// Tells the kind of the value that begins next, without reading any of it.
  Kind peek();
  /// Reads a string. Only the first 256 bytes of a long one are kept; `hash` tells long strings
  /// apart.
  const std::string& string();
  std::uint64_t hash() const { return hash_; }
  /// Reads a number and returns its text.
  const std::string& number();
  /// Reads true, false or null, or for the sake of a message one of the words that are not JSON
  /// (NaN, Infinity).
  const std::string& literal();

  /// Skips the bracket or brace that opens a value. Returns whether the value contains anything.
  bool open(char opening, char closing);
  /// Skips a comma and returns true, or skips the closing bracket and returns false.
  bool more(char closing);
  /// Skips the colon after a key.
  void colon();
  /// Throws Error unless only white space is left.
  void require_end();

  [[noreturn]] void fail(std::string text) const;
  const std::string& file() const { return file_; }

 private:
  struct Bytes;

  int look();
  int take();
  void skip_space();
  void expect(char wanted);
  void escape();
  unsigned four_digits();
  void continuation(int lead);
  void keep(int byte);
  std::string shown(int byte) const;

  std::string file_;
  std::unique_ptr<Bytes> bytes_;
  std::size_t line_ = 1;
  std::size_t offset_ = 0;
  std::string text_;
  std::uint64_t hash_ = 0;
};

}  // namespace thiessen
