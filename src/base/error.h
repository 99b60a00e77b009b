#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/wording.h"

namespace thiessen {

/// One thing that a user should know: what is wrong or odd, where it is, and what to do about it.
struct Message {
  std::string file;      ///< the file as the user named it; empty where no file is to blame
  std::size_t line = 0;  ///< the line, from 1; 0 where the file has no lines
  Wording text;
  Wording hint;  ///< what to do about it; may be empty

  /// The message as `file:line: text`, without the hint.
  Wording placed() const;
  /// The message as `file:line: text` as a caller of the library reads it, on one line, without the
  /// hint, and with control characters shown as `\x1b`.
  std::string sentence() const;
};

/// The exception for bad input or a failing machine. It carries everything that was found: the
/// first 20 messages whole, and the number of the rest. A hint stands with the first message that
/// it belongs to.
class Error : public std::exception {
 public:
  explicit Error(Message message);
  Error(std::vector<Message> messages, std::size_t unlisted);

  /// The messages in the order of the file.
  const std::vector<Message>& messages() const { return messages_; }
  /// How many further messages were found beyond those listed.
  std::size_t unlisted() const { return unlisted_; }
  /// All messages as sentences, one on each line.
  const char* what() const noexcept override { return what_.c_str(); }

 private:
  std::vector<Message> messages_;
  std::size_t unlisted_ = 0;
  std::string what_;
};

/// The exception where whoever reads what is written has gone. There is nobody to tell of it.
class ReaderGone : public Error {
 public:
  explicit ReaderGone(Error error) : Error(std::move(error)) {}
};

/// Gathers the faults in the rows of a file, so that all are reported, not only the first.
class Complaints {
 public:
  static constexpr std::size_t listed_at_most = 20;

  void add(Message message);
  /// Adds a message of a file whose faults are found in another order than that of its lines. The
  /// listed messages are then the first ones by line.
  void add_by_line(Message message);
  /// Takes over what else was found in the same file, and puts all messages in the order of the
  /// lines.
  void add(const Error& error) { merge(error.messages(), error.unlisted()); }
  void add(const Complaints& other) { merge(other.messages_, other.unlisted_); }
  bool empty() const { return messages_.empty(); }
  /// Throws all messages as one Error; does nothing where there are none.
  void throw_if_any();
  /// Throws all messages, and with them a last one after which reading cannot go on.
  [[noreturn]] void fail(const Message& last);

 private:
  void merge(const std::vector<Message>& messages, std::size_t unlisted);

  std::vector<Message> messages_;
  std::size_t unlisted_ = 0;
};

/// What was odd but is no error, in the order found, and apart from it what was taken for granted.
/// The library never prints these; its caller does.
class Warnings {
 public:
  /// Adds a message. A hint that another message has given is left out. Cost: linear in the number
  /// of different hints.
  void add(Message message);
  /// Adds what a user should know though nothing is odd about it: a choice that was made for lack
  /// of another.
  void add_notice(Message message) { notices_.push_back(std::move(message)); }
  const std::vector<Message>& messages() const { return messages_; }
  const std::vector<Message>& notices() const { return notices_; }
  /// Drops the messages, for they have been told.
  void have_been_told() {
    messages_.clear();
    notices_.clear();
  }

 private:
  std::vector<Message> messages_;
  std::vector<Wording> hints_;
  std::vector<Message> notices_;
};

/// The text made fit for a terminal: control characters are written as `\x1b`, and bytes that are
/// not UTF-8 as `\xff`.
std::string printable(std::string_view text);

}  // namespace thiessen
