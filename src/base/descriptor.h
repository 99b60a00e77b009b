#pragma once

#include <string>
#include <utility>

#include "base/error.h"

namespace thiessen {

/// Owns the descriptor of an open file, and closes it in its destructor.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  /// Closes the file. Returns whether that succeeded; if not, `errno` tells why.
  bool close();
  /// Hands the file over to an owner of another kind, who is to close it.
  int release() { return std::exchange(number_, -1); }
  /// Another descriptor of the same open file, as twin_of has it, to write by. `file` names it in
  /// the Error that is thrown where the system has none left.
  Descriptor twin(const std::string& file) const;

 private:
  int number_ = -1;
};

/// Opens a file with O_CLOEXEC and O_NOCTTY, and tries again after a signal that is no reason to
/// stop. Throws Interrupted where it is one. Where opening fails the descriptor is not open, and
/// `errno` tells why.
Descriptor open_descriptor(const std::string& path, int flags, unsigned mode = 0);

/// Makes another descriptor of the same open file, with O_CLOEXEC, and above the numbers of the
/// standard streams, so that it is never taken for one of them. Where that fails it is not open,
/// and `errno` tells why.
Descriptor twin_of(int number);

/// Makes the Error for a system call that failed: `file: what: reason of errno`.
Error system_error(const std::string& file, const std::string& what, int error_number);

/// Opens whichever of the standard input, output and error the program was started without, so that
/// no file it opens takes their number. Whatever reads from or writes to such a stream fails as
/// before.
void hold_standard_streams();

}  // namespace thiessen
