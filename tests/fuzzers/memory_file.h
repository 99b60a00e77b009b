#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include <sys/mman.h>
#include <unistd.h>

#include "base/descriptor.h"
#include "base/file.h"

namespace thiessen::fuzzers {

/// A file in no folder, which has a name all the same.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view text = {})
      : file_(::memfd_create("fuzzed", MFD_CLOEXEC)), name_(path_of(file_.number())) {
    if (!file_.is_open() ||
        ::write(file_.number(), text.data(), text.size()) != static_cast<ssize_t>(text.size()))
      throw std::runtime_error("no memory file");
  }

  const std::string& name() const { return name_; }
  /// Writes to its end.
  OutputFile output() const { return {"-", file_.twin("-"), OutputFile::Care::closed}; }
  /// All that was written since the last time.
  std::string take() {
    const auto size = static_cast<std::size_t>(::lseek(file_.number(), 0, SEEK_END));
    std::string text(size, '\0');
    const ssize_t count = ::pread(file_.number(), text.data(), size, 0);
    if (count != static_cast<ssize_t>(size) || ::ftruncate(file_.number(), 0) != 0)
      throw std::runtime_error("a memory file fails");
    ::lseek(file_.number(), 0, SEEK_SET);
    return text;
  }

 private:
  static std::string path_of(int number) { return "/proc/self/fd/" + std::to_string(number); }

  Descriptor file_;
  std::string name_;
};

}  // namespace thiessen::fuzzers
