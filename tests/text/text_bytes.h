#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "text/byte_source.h"

namespace thiessen {

/// The bytes of a text in memory. They come in pieces of `piece` bytes, so that a reader's seams
/// can be put anywhere.
class TextBytes final : public ByteSource {
 public:
  explicit TextBytes(std::string text, std::size_t piece = 65536)
      : text_(std::move(text)), piece_(piece) {}

  std::size_t read(char* buffer, std::size_t capacity) override {
    const std::size_t count = std::min({capacity, piece_, text_.size() - at_});
    std::copy_n(text_.begin() + static_cast<std::ptrdiff_t>(at_), count, buffer);
    at_ += count;
    return count;
  }

 private:
  std::string text_;
  std::size_t piece_;
  std::size_t at_ = 0;
};

}  // namespace thiessen
