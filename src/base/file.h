#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/descriptor.h"

namespace thiessen {

/// A file to read from beginning to end: a plain file, a pipe, a device, or `-`, the standard
/// input.
class InputFile {
 public:
  /// Throws Error where the name is empty or cannot be opened, is a folder, or is a named pipe to
  /// which nobody writes within three seconds.
  explicit InputFile(const std::string& name);

  /// As the user named it; "standard input" for `-`.
  const std::string& name() const { return name_; }
  /// In bytes, as it was when it was opened; 0 where that is not known, as of a pipe.
  std::size_t size() const { return size_; }
  /// Fills the beginning of `into` with what comes next and returns how many bytes that is, 0 at
  /// the end. Throws Error where reading fails, Interrupted where a signal came.
  std::size_t read(std::span<char> into);

 private:
  void open(const std::string& path);
  void await_writer();

  std::string name_;
  Descriptor file_;
  std::size_t size_ = 0;
  std::optional<char> first_;  ///< already read, while waiting for a writer
};

/// A file being written, through a buffer; every write is checked. See Outputs, which makes them.
class OutputFile {
 public:
  /// What has to happen before the bytes count as written.
  enum class Care {
    closed,  ///< the system took them: pipes, devices, the standard output
    held,    ///< the same, but none of them goes there before `finish`: what was printed cannot be
             ///< taken back. What the buffer cannot hold waits in a temporary file (see spool.h)
    synced,  ///< they are on the disk
  };

  OutputFile(std::string name, Descriptor file, Care care);

  /// As the user named it, for messages; "standard output" for `-`.
  const std::string& name() const { return name_; }
  /// Adds to the end. Throws Error where the system refuses: a full disk, a closed pipe.
  void append(std::string_view text);
  /// Hands over what the buffer holds, so that a reader of a pipe sees it (held: nobody does yet).
  void flush();
  /// Writes the rest, syncs and closes; only when this does not throw are the bytes safe.
  void finish();

 private:
  void write(std::string_view text);

  std::string name_;
  Descriptor file_;
  Care care_;
  std::string buffer_;
  Descriptor spool_;  ///< open once held bytes exceed the buffer
};

/// The standard output as a checked file. Throws Error where it is closed.
OutputFile standard_output(OutputFile::Care care = OutputFile::Care::closed);

/// Asks the disk for what a file or folder holds. Throws Error where that fails.
void sync_to_disk(int descriptor, const std::string& name);

}  // namespace thiessen
