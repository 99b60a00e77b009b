#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace thiessen {

/// How much of each pixel a shape covers, from 0 to 255, row by row.
struct Coverage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;

  Coverage() = default;
  Coverage(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  std::uint8_t& at(int x, int y) { return values[offset(x, y)]; }
  std::uint8_t at(int x, int y) const { return values[offset(x, y)]; }

 private:
  std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

enum class Weight { regular, bold };

/// A line of text as set: the coverage of its ink, cut to the ink's width, and what it says and
/// how.
struct SetText {
  Coverage ink;
  int baseline = 0;  ///< the row of `ink` on which the letters stand
  std::string text;  ///< UTF-8 in reading order, as far as it is shown
  int size = 0;      ///< pixels to the em
  Weight weight = Weight::regular;
  bool right_to_left = false;  ///< the direction of the whole line
  bool is_shortened = false;   ///< whether the text goes on after what is shown

  int width() const { return ink.width; }
  int height() const { return ink.height; }
};

}  // namespace thiessen
