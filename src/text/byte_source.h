#pragma once

#include <cstddef>

namespace thiessen {

/// The bytes of a text in their order, wherever they come from: a file, an archive, memory.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Puts the next bytes, `capacity` at most, into `buffer`, and returns how many they are; 0 at
  /// the end.
  virtual std::size_t read(char* buffer, std::size_t capacity) = 0;
};

}  // namespace thiessen
