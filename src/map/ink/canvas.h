#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// A colour in the three channels of a pixel, each from 0 to 255.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// A rectangle of whole pixels: (x, y) is its upper left, and it reaches `width` to the right and
/// `height` down.
struct PixelBox {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  int right() const { return x + width; }
  int bottom() const { return y + height; }
};

/// How much of each pixel a shape covers, from 0 to 255, row by row.
struct Coverage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> values;

  Coverage() = default;
  Coverage(int w, int h);
  std::uint8_t& at(int x, int y) { return values[offset(x, y)]; }
  std::uint8_t at(int x, int y) const { return values[offset(x, y)]; }

 private:
  std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// The pixels of a picture, white at first. Drawing outside the picture changes nothing.
class Canvas {
 public:
  Canvas(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  /// The bytes of all pixels: blue, green, red for each, row by row from the top.
  std::vector<std::uint8_t>& bytes() { return bytes_; }

  void set(int x, int y, Colour colour);
  /// Mixes `colour` into a pixel with weight `alpha` / 255.
  void blend(int x, int y, Colour colour, int alpha);
  /// Mixes `colour` into the pixels under `coverage`, whose upper left is placed at (x, y), each
  /// weighted by its coverage and by `alpha` / 255.
  void blend(int x, int y, const Coverage& coverage, Colour colour, int alpha = 255);
  void fill(const PixelBox& box, Colour colour);
  /// Draws a border of `thickness` pixels inside the box.
  void border(const PixelBox& box, Colour colour, int thickness);
  /// Fills a disc with a smooth edge. Centre and radius are in pixels; a pixel has its centre at
  /// .5. Only pixels inside `clip` change.
  void disc(Point centre, double radius, Colour colour, const PixelBox& clip);

 private:
  std::uint8_t* pixel(int x, int y);

  int width_;
  int height_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace thiessen
