#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/ink/canvas.h"

namespace thiessen {

/// The pixels of a picture, white at first, drawn on by OpenCV. The same calls give the same
/// pixels, whatever the number of OpenCV's threads.
class PixelCanvas : public Canvas {
 public:
  PixelCanvas(int width, int height);

  /// The bytes of all pixels: blue, green, red for each, row by row from the top.
  std::vector<std::uint8_t>& bytes() { return bytes_; }
  /// How far the box's pixels are from white, all channels together.
  std::uint64_t darkness(const PixelBox& box);

  void fill(const PixelBox& box, Colour colour) override;
  void border(const PixelBox& box, Colour colour, int thickness) override;
  void areas(std::span<const Area> areas, const Hatch& hatch, const Window& window) override;
  void lines(std::span<const Polyline> lines, const Stroke& stroke, const Window& window) override;
  void text(const SetText& text, int x, int y, const Lettering& lettering) override;
  void begin(const Mark&) override {}
  void end() override {}

 private:
  void draw_disc(Point centre, double radius, Colour colour, const PixelBox& clip,
                 const Mark& mark) override;
  void blend(int x, int y, const Coverage& coverage, Colour colour, int alpha);

  std::vector<std::uint8_t> bytes_;
};

}  // namespace thiessen
