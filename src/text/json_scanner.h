#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "text/byte_source.h"

namespace thiessen {

/// Cuts the text of a JSON file (RFC 8259, UTF-8) into its tokens, in memory that does not grow
/// with the file. Throws Error with the line at the first byte that is not JSON.
class JsonScanner {
 public:
  enum class Kind { object, array, string, number, literal, end };

  /// `file` is the name that messages give the text. `source` must outlive the scanner.
  JsonScanner(std::string file, ByteSource& source);
  ~JsonScanner();

  /// What kind of value begins next; nothing of it is read.
  Kind peek();
  /// Reads a string; of a long one only the first 256 bytes are kept. `hash` tells long ones apart.
  const std::string& string();
  std::uint64_t hash() const { return hash_; }
  /// Reads a number's text.
  const std::string& number();
  /// Reads true, false, null, or one of the words that are no JSON (NaN, Infinity), for a message.
  const std::string& literal();

  /// Skips the bracket or brace that opens a value, and says whether anything stands in it.
  bool open(char opening, char closing);
  /// Skips a comma (true) or the closing bracket (false).
  bool more(char closing);
  void colon();
  /// Throws unless nothing but white space is left.
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
