#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/descriptor.h"

namespace thiessen {

/// A file to read from beginning to end: a plain file, a pipe, a device, or `-`, the standard
/// input.
class InputFile {
 public:
  /// Throws Error where the name is empty or cannot be opened, is a folder, or is a named pipe to
  /// which nobody writes within three seconds.
  explicit InputFile(const std::string& name);
  /// Gives bytes in their order: reads the next ones into the beginning of `into`, and returns how
  /// many they are; 0 at the end.
  using Source = std::function<std::size_t(std::span<char> into)>;
  /// A file whose bytes are had from a source, such as an archive.
  InputFile(std::string name, Source source) : name_(std::move(name)), source_(std::move(source)) {}

  /// The name as the user gave it; "standard input" for `-`.
  const std::string& name() const { return name_; }
  /// The size in bytes when the file was opened; 0 where it is not known, as for a pipe.
  std::size_t size() const { return size_; }
  /// Whether its bytes may come bit by bit, as those of a pipe do: whoever wants many waits.
  bool may_wait() const { return file_.is_open() && size_ == 0; }
  /// Reads the next bytes into the beginning of `into`, and returns how many they are; 0 at the
  /// end. Throws Error where reading fails, and Interrupted where a signal came.
  std::size_t read(std::span<char> into);
  /// Whether bytes are there, or come within `patience`; so is the end. Only of a pipe or a device
  /// is it ever false. Throws Interrupted where a signal came.
  bool has_bytes(std::chrono::milliseconds patience);

 private:
  void open(const std::string& path);
  void await_writer();

  std::string name_;
  Descriptor file_;
  std::size_t size_ = 0;
  Source source_;              ///< where the bytes come from, if not from `file_`
  std::optional<char> first_;  ///< a byte that was read while waiting for a writer
};

/// A file that is written through a buffer; every write is checked. See Outputs, which makes such
/// files.
class OutputFile {
 public:
  /// What has to happen before the bytes count as written.
  enum class Care {
    closed,  ///< the system took the bytes: for pipes, devices, the standard output
    held,    ///< as closed, but no byte goes there before `finish`, because what was printed cannot
             ///< be taken back; what the buffer cannot hold waits in a temporary file (spool.h)
    synced,  ///< the bytes are on the disk
  };

  OutputFile(std::string name, Descriptor file, Care care);

  /// The name as the user gave it, for messages; "standard output" for `-`.
  const std::string& name() const { return name_; }
  /// Appends the text. Throws Error where the system refuses it: a full disk, a closed pipe.
  void append(std::string_view text);
  /// Hands over what the buffer holds, so that the reader of a pipe sees it. Throws ReaderGone
  /// where there is none left. Held bytes stay where
  /// no reader sees them yet.
  void flush();
  /// Writes the rest, and waits until it is on the disk, where the file is to be synced.
  void sync();
  /// As sync, and closes the file. The bytes are safe only when this does not throw.
  void finish();
  /// Has `finish` hand over the file when it is synced, before it is closed.
  void before_closing(std::function<void(const Descriptor& file)> take) {
    before_closing_ = std::move(take);
  }
  /// Drops what is not handed over yet.
  void discard();
  /// Drops all that was appended, so that something else may be written in its place. Requires care
  /// `held` or `synced`, and that it is not finished.
  void start_over();
  /// Whether it is a pipe from which nobody will read any more.
  bool is_reader_gone() const;
  /// Another output to the same place, none of whose bytes go there until it is finished. What this
  /// one holds has to be flushed first. Throws Error where the system has no more descriptors.
  OutputFile held() const;

 private:
  void write(std::string_view text);

  std::string name_;
  Descriptor file_;
  Care care_;
  std::string buffer_;
  Descriptor spool_;  ///< open once held bytes exceed the buffer
  bool is_synced_ = false;
  std::function<void(const Descriptor&)> before_closing_;
};

/// The standard output as a checked file. Throws Error where it is closed.
OutputFile standard_output(OutputFile::Care care = OutputFile::Care::closed);

/// Waits until what a file or folder holds is on the disk. Throws Error where that fails.
void sync_to_disk(int descriptor, const std::string& name);

}  // namespace thiessen
