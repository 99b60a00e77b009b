#pragma once

#include <span>

namespace thiessen {

/// A file that holds a raster for each step of a series, written one step after the other. Every
/// function throws Error where the file cannot be written.
class GridFile {
 public:
  virtual ~GridFile() = default;
  /// Writes the next step: all pixels, row by row from the north, NaN outside.
  virtual void add(std::span<const float> pixels) = 0;
};

}  // namespace thiessen
