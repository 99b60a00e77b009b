#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/colour.h"
#include "geometry/point.h"
#include "geometry/polygon.h"
#include "map/ink/set_text.h"

namespace thiessen {

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

/// The part of the page to which shapes are cut, and the place on the page from which their
/// coordinates count.
struct Window {
  PixelBox box;
  Point origin;
};

/// What a thing in the picture is, for canvases that can say so of it: its kind, such as "cell",
/// the ids of its station and its basin, and the level of rainfall, where it has any. `part` is the
/// stretch of a text that is meant; empty: all of it.
struct Mark {
  std::string_view kind{};
  std::string_view station{};
  std::string_view basin{};
  std::string_view part{};
  std::string_view level{};
};

/// Stripes over a filled shape, from the upper right to the lower left. Both lengths are taken
/// along a row of pixels.
struct Hatch {
  Colour colour;
  double spacing = 8;
  double width = 1;
};

/// A shape to fill. Each of its parts is filled by the even-odd rule.
struct Area {
  std::vector<std::span<const Ring>> parts;
  Colour colour;
  bool hatched = false;
  Mark mark{};
};

using Polyline = std::span<const Point>;

/// The look of a line. All lengths are in pixels; without a dash the line is solid. `alpha` / 255
/// is its opacity.
struct Stroke {
  Colour colour;
  double width = 1;
  int alpha = 255;
  double dash = 0;
  double gap = 0;
};

/// The look of a text: its colour, and the width of the white rim that sets it off.
struct Lettering {
  Colour colour;
  int halo = 0;
  Mark mark{};
};

/// What a picture is drawn on: pixels (map/opencv) or an SVG (map/svg).
///
/// Coordinates are in pixels, x to the right and y down; a pixel has its centre at .5. What is
/// drawn later covers what was drawn before, and what is drawn outside the page changes nothing.
/// Requires coordinates within half a million pixels of the page.
class Canvas {
 public:
  Canvas(int width, int height) : width_(width), height_(height) {}
  virtual ~Canvas() = default;

  int width() const { return width_; }
  int height() const { return height_; }

  virtual void fill(const PixelBox& box, Colour colour) = 0;
  /// Draws a border of `thickness` pixels inside the box.
  virtual void border(const PixelBox& box, Colour colour, int thickness) = 0;
  /// Fills a disc with a smooth edge, as far as it lies in `clip`.
  void disc(Point centre, double radius, Colour colour, const PixelBox& clip,
            const Mark& mark = {}) {
    draw_disc(centre, radius, colour, clip, mark);
  }
  /// Fills areas, the later ones over the earlier ones. Nothing shows between areas that share an
  /// edge.
  virtual void areas(std::span<const Area> areas, const Hatch& hatch, const Window& window) = 0;
  /// Draws lines with round ends and smooth edges. Where lines of one call overlap they are no
  /// darker than one of them.
  virtual void lines(std::span<const Polyline> lines, const Stroke& stroke,
                     const Window& window) = 0;
  /// Draws a text; (x, y) is the upper left of its ink.
  virtual void text(const SetText& text, int x, int y, const Lettering& lettering) = 0;
  /// Begins and ends a group of things that have one mark.
  virtual void begin(const Mark& mark) = 0;
  virtual void end() = 0;

 protected:
  Canvas(const Canvas&) = default;
  Canvas(Canvas&&) = default;
  Canvas& operator=(const Canvas&) = default;
  Canvas& operator=(Canvas&&) = default;

 private:
  virtual void draw_disc(Point centre, double radius, Colour colour, const PixelBox& clip,
                         const Mark& mark) = 0;

  int width_;
  int height_;
};

/// A group on a canvas, as long as this lives.
class Group {
 public:
  Group(Canvas& canvas, const Mark& mark) : canvas_(canvas) { canvas_.begin(mark); }
  ~Group() { canvas_.end(); }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

 private:
  Canvas& canvas_;
};

}  // namespace thiessen
