#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "map/opencv/pixel_canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/page.h"

namespace thiessen {

/// A page with a bordered panel, a legend above it and notes below.
class PlotSheet {
 public:
  static constexpr int width = 1600;

  enum class Margins { plain, for_axes };

  /// `aspect` is the width of the panel divided by its height.
  PlotSheet(double aspect, Margins margins);

  PixelCanvas& canvas() { return canvas_; }
  Typesetter& type() { return type_; }
  const PageStyle& style() const { return style_; }
  const PixelBox& panel() const { return panel_; }

  /// Which part of a text is placed at the given x: its left end, its middle or its right end.
  enum class Align { left, centre, right };
  void write(const SetText& text, int x, int baseline, Align align, Colour colour);

  /// Writes what red and blue lines stand for, and how many points there are.
  void write_legend(std::size_t points);
  /// Writes a note on the lowest line, to the right of the notes written before.
  void write_note(const std::string& note);
  /// Writes a sentence in the middle of the panel.
  void write_sentence(std::string_view sentence);
  void draw_border();

 private:
  PageStyle style_;
  PixelBox panel_;
  PixelCanvas canvas_;
  Typesetter type_;
  int note_left_;
};

}  // namespace thiessen
