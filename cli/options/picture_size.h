#pragma once

#include <cstddef>

#include "cli/options/option_values.h"

namespace thiessen::cli {

/// The size of a picture as its user tells it: in pixels, or in millimetres and dots to the inch.
struct PictureSize {
  PixelSize size;
  std::size_t dpi = 0;  ///< 0: none is said

  /// The picture's size in pixels: as given, or in millimetres by the density. A height of 0 is
  /// chosen by the shape of what is shown.
  int width() const;
  int height() const;
  /// What the picture tells a printer; 0: nothing. A size in millimetres has 300 unless told.
  int dots_to_the_inch() const;
  /// Throws UsageError for a size in millimetres that takes too few or too many pixels.
  void check_size() const;

 private:
  int pixels(std::size_t side) const;
};

}  // namespace thiessen::cli
