#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/descriptor.h"
#include "base/destination.h"
#include "base/file.h"

namespace thiessen {

/// A file to which a run adds, and which no other run adds to until this object is gone: it is
/// locked (flock), where the file system can do that.
///
/// It is either replaced by a longer one (see Outputs), or grows in place, which a reader sees as
/// it happens. A file that has grown in place always ends where `keep` was called last, whatever
/// fails.
class GrownFile {
 public:
  /// Opens the file, if there is one, and waits up to five seconds for another run that adds to it.
  /// Throws Error where the name is no plain file's, is one of the inputs, or another run keeps it.
  GrownFile(std::string path, OutputRules rules);
  GrownFile(const GrownFile&) = delete;
  GrownFile& operator=(const GrownFile&) = delete;
  ~GrownFile();

  bool exists() const { return exists_; }
  std::size_t size() const { return static_cast<std::size_t>(status_.st_size); }
  /// Reads from a place on, and returns how many bytes that are; 0 at the end.
  std::size_t read(std::size_t at, std::span<char> into) const;
  /// Throws Error where the path has another file by now, or this one has changed.
  void require_unchanged() const;

  /// Shortens the file to so many bytes, or makes it, and returns an output whose bytes are added.
  /// This object must outlive it.
  OutputFile& grow(std::size_t from);
  /// Hands over what was added, and keeps it whatever follows. Throws Error where that fails.
  void keep();

 private:
  void open();
  bool lock();
  bool is_at_path() const;
  void make();
  void shorten(std::size_t to) const;

  std::string path_;
  OutputRules rules_;
  Descriptor file_;
  struct stat status_ = {};
  bool exists_ = false;
  bool grows_ = false;
  std::size_t kept_ = 0;  ///< bytes
  std::optional<OutputFile> output_;
};

}  // namespace thiessen
