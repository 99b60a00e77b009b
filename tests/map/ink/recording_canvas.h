#pragma once

#include <vector>

#include "map/ink/canvas.h"

namespace thiessen {

/// A canvas that keeps the discs drawn on it, and nothing else.
class RecordingCanvas : public Canvas {
 public:
  using Canvas::Canvas;

  struct Disc {
    Point centre;
    double radius;
    Colour colour;
    PixelBox clip;
  };
  std::vector<Disc> discs;

  void fill(const PixelBox&, Colour) override {}
  void border(const PixelBox&, Colour, int) override {}
  void areas(std::span<const Area>, const Hatch&, const Window&) override {}
  void lines(std::span<const Polyline>, const Stroke&, const Window&) override {}
  void text(const SetText&, int, int, const Lettering&) override {}
  void begin(const Mark&) override {}
  void end() override {}

 private:
  void draw_disc(Point centre, double radius, Colour colour, const PixelBox& clip,
                 const Mark& /*mark*/) override {
    discs.push_back({centre, radius, colour, clip});
  }
};

}  // namespace thiessen
