#pragma once

#include <string>
#include <utility>

#include "base/error.h"

namespace thiessen {

/// An open file, closed when it goes.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  /// Closes it; whether that succeeded. `errno` tells why not.
  bool close();

 private:
  int number_ = -1;
};

/// `open` with O_CLOEXEC and O_NOCTTY, tried again when a signal came that is no reason to stop.
/// Not open where it failed; `errno` tells why.
Descriptor open_descriptor(const std::string& path, int flags, unsigned mode = 0);

/// The Error for a call of the system that failed: `file: what: reason of errno`.
Error system_error(const std::string& file, const std::string& what, int error_number);

/// Fills the standard input, output and error, where the program was started with one of them
/// closed, so that no file it opens takes their number; whatever reads or writes such a one fails
/// as before.
void hold_standard_streams();

}  // namespace thiessen
