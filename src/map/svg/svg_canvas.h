#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "map/ink/canvas.h"

namespace thiessen {

/// A picture as an SVG (1.1, and `paint-order` of SVG 2, which older viewers pass over): text stays
/// text, and marks become attributes `class`, `data-station`, `data-basin` and `data-level`. A
/// coordinate has two decimals. The same calls give the same bytes.
class SvgCanvas : public Canvas {
 public:
  using Canvas::Canvas;

  /// The whole document. Where `dpi` is above 0 it has its size on paper, so many pixels to the
  /// inch. Requires that every group was ended.
  std::string document(std::string_view title, std::string_view description, double dpi) const;

  void fill(const PixelBox& box, Colour colour) override;
  void border(const PixelBox& box, Colour colour, int thickness) override;
  void disc(Point centre, double radius, Colour colour, const PixelBox& clip) override;
  void areas(std::span<const Area> areas, const Hatch& hatch, const Window& window) override;
  void lines(std::span<const Polyline> lines, const Stroke& stroke, const Window& window) override;
  void text(const SetText& text, int x, int y, const Lettering& lettering) override;
  void begin(const Mark& mark) override;
  void end() override;

 private:
  std::string clip_path(const PixelBox& box);

  std::string body_;
  std::string clip_;       ///< the box of the last clip path
  std::size_t clips_ = 0;  ///< how many there are: their ids are c1, c2 ...
  std::size_t hatches_ = 0;
};

}  // namespace thiessen
