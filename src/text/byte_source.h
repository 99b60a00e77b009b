#pragma once

#include <cstddef>

namespace thiessen {

/// A source that gives the bytes of a text in their order, wherever they come from: a file, an
/// archive, memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Reads the next bytes, at most `capacity`, into `buffer`, and returns how many they are; 0 at
  /// the end.
  virtual std::size_t read(char* buffer, std::size_t capacity) = 0;
};

}  // namespace thiessen
