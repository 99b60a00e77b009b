#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/descriptor.h"

namespace thiessen::fuzzers {

/// A pipe that holds a text, and gives it in pieces: each read returns one of them, so that a
/// reader's seams can be put anywhere. It can be read once.
class MemoryPipe {
 public:
  static constexpr std::size_t longest_text = 2000;

  /// Requires a text that is not empty and has at most `longest_text` bytes. Pieces are longer than
  /// `piece` where there would be more of them than a pipe holds.
  MemoryPipe(std::string_view text, std::size_t piece) {
    constexpr std::size_t most_pieces = 50;
    constexpr int bytes_for_them = 1 << 18;
    int ends[2] = {};
    if (::pipe2(ends, O_CLOEXEC | O_DIRECT) != 0) throw std::runtime_error("no pipe");
    file_ = Descriptor(ends[0]);
    const Descriptor writer(ends[1]);
    if (::fcntl(writer.number(), F_SETPIPE_SZ, bytes_for_them) < 0)
      throw std::runtime_error("a pipe that holds too little");
    piece = std::max(piece, text.size() / most_pieces + 1);
    for (; !text.empty(); text.remove_prefix(std::min(piece, text.size()))) {
      const std::string_view next = text.substr(0, piece);
      if (::write(writer.number(), next.data(), next.size()) != static_cast<ssize_t>(next.size()))
        throw std::runtime_error("a pipe fails");
    }
    name_ = "/proc/self/fd/" + std::to_string(file_.number());
  }

  const std::string& name() const { return name_; }

 private:
  Descriptor file_;
  std::string name_;
};

}  // namespace thiessen::fuzzers
