#pragma once

#include <cstdint>

namespace thiessen {

/// A colour in the three channels of a pixel, each from 0 to 255.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

}  // namespace thiessen
