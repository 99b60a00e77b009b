#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include "base/descriptor.h"

namespace thiessen {

/// A pipe that a test feeds bit by bit, and reads by its name.
class FedPipe {
 public:
  FedPipe() {
    int ends[2] = {};
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    from_ = Descriptor(ends[0]);
    to_ = Descriptor(ends[1]);
  }

  std::string path() const { return "/dev/fd/" + std::to_string(from_.number()); }
  /// Requires that the pipe holds so much.
  void feed(std::string_view text) {
    if (::write(to_.number(), text.data(), text.size()) != static_cast<ssize_t>(text.size()))
      throw std::runtime_error("a pipe that holds too little");
  }
  void end() { to_.close(); }

 private:
  Descriptor from_;
  Descriptor to_;
};

}  // namespace thiessen
