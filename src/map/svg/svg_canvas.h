#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "map/ink/canvas.h"

namespace thiessen {

/// The size of a page on paper, in millimetres; a side of 0 is not known.
struct PaperSize {
  double width = 0;
  double height = 0;
};

/// A picture as an SVG (1.1, and `paint-order` of SVG 2, which older viewers pass over): text stays
/// text, and marks become attributes `class`, `data-station`, `data-basin` and `data-level`. A
/// coordinate has two decimals. The same calls give the same bytes.
class SvgCanvas : public Canvas {
 public:
  using Canvas::Canvas;

  /// The whole document, which has its size on paper where one is known. Requires that every group
  /// was ended.
  std::string document(std::string_view title, std::string_view description,
                       const PaperSize& paper = {}) const;

  void fill(const PixelBox& box, Colour colour) override;
  void border(const PixelBox& box, Colour colour, int thickness) override;
  void areas(std::span<const Area> areas, const Hatch& hatch, const Window& window) override;
  void lines(std::span<const Polyline> lines, const Stroke& stroke, const Window& window) override;
  void text(const SetText& text, int x, int y, const Lettering& lettering) override;
  void begin(const Mark& mark) override;
  void end() override;

 private:
  void draw_disc(Point centre, double radius, Colour colour, const PixelBox& clip,
                 const Mark& mark) override;
  std::string clip_path(const PixelBox& box);

  std::string body_;
  std::string clip_;       ///< the box of the last clip path
  std::size_t clips_ = 0;  ///< how many there are: their ids are c1, c2 ...
  std::size_t hatches_ = 0;
};

}  // namespace thiessen
