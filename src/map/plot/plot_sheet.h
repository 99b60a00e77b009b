#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "map/opencv/pixel_canvas.h"
#include "map/opencv/typesetter.h"
#include "map/plot/tessellation_picture.h"
#include "map/sheet/page.h"

namespace thiessen {

/// A page with a bordered panel, a legend above it and notes below. A page too small for any text
/// is the panel alone.
class PlotSheet {
 public:
  enum class Margins { plain, for_axes };

  /// `aspect` is the width of the panel divided by its height. The panel is as large as the page
  /// lets it be, in the middle of the room for it; a page without a height gets one that fits, but
  /// not beyond a square panel's.
  PlotSheet(double aspect, Margins margins, const PlotSize& size = {});

  /// The aspect of a panel that takes all the room of a page whose height is given.
  static double aspect_of_room(Margins margins, const PlotSize& size);

  PixelCanvas& canvas() { return canvas_; }
  Typesetter& type() { return type_; }
  const PageStyle& style() const { return style_; }
  const PixelBox& panel() const { return panel_; }

  /// Which part of a text is placed at the given x: its left end, its middle or its right end.
  enum class Align { left, centre, right };
  void write(const SetText& text, int x, int baseline, Align align, Colour colour);

  /// Writes what red and blue lines stand for, and how many of how many points are in sight.
  void write_legend(std::size_t in_sight, std::size_t points);
  /// Writes a note on the lowest line, to the right of the notes written before.
  void write_note(const std::string& note);
  /// Writes a sentence in the middle of the panel.
  void write_sentence(std::string_view sentence);
  void draw_border();

 private:
  PageStyle style_;
  PixelBox room_;
  PixelBox panel_;
  PixelCanvas canvas_;
  Typesetter type_;
  int note_left_;
};

}  // namespace thiessen
