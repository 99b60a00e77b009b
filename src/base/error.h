#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "base/wording.h"

namespace thiessen {

/// One thing that a user should know: what is wrong or odd, where, and what to do about it.
struct Message {
  std::string file;      ///< as the user named it; empty where no file is to blame
  std::size_t line = 0;  ///< from 1; 0 where the file has no lines
  Wording text;
  Wording hint;  ///< may be empty

  /// `file:line: text` without the hint.
  Wording placed() const;
  /// The same as a caller of the library reads it, control characters shown as \x1b, on one line.
  std::string sentence() const;
};

/// Bad input or a failing machine: everything that was found, the first 20 whole and the rest
/// counted.
class Error : public std::exception {
 public:
  explicit Error(Message message);
  Error(std::vector<Message> messages, std::size_t unlisted);

  /// In the order of the file.
  const std::vector<Message>& messages() const { return messages_; }
  /// How many further messages were found beyond those listed.
  std::size_t unlisted() const { return unlisted_; }
  /// All sentences, a line each.
  const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::vector<Message> messages_;
  std::size_t unlisted_ = 0;
  std::string what_;
};

/// Gathers the bad rows of a file, so that all are reported and not the first alone.
class Complaints {
 public:
  static constexpr std::size_t listed_at_most = 20;

  void add(Message message);
  /// The same for those of one file that are found in another order than that of its lines: the
  /// listed ones are the first by line.
  void add_by_line(Message message);
  /// Takes over what else was found in the same file, and puts all in the order of the lines.
  void add(const Error& error) { merge(error.messages(), error.unlisted()); }
  void add(const Complaints& other) { merge(other.messages_, other.unlisted_); }
  bool empty() const { return messages_.empty(); }
  /// Throws all of them as one Error; does nothing where there are none.
  void throw_if_any();
  /// Throws all of them, and one more after which reading cannot go on.
  [[noreturn]] void fail(const Message& last);

 private:
  void merge(const std::vector<Message>& messages, std::size_t unlisted);

  std::vector<Message> messages_;
  std::size_t unlisted_ = 0;
};

/// What was odd but no error, in the order found. The library never prints: the caller does.
class Warnings {
 public:
  void add(Message message) { messages_.push_back(std::move(message)); }
  const std::vector<Message>& messages() const { return messages_; }

 private:
  std::vector<Message> messages_;
};

/// The text with control characters as \x1b and bytes that are not UTF-8 as \xff, fit for a
/// terminal.
std::string printable(std::string_view text);

}  // namespace thiessen
