#include "map/plot/plot_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "map/ink/ink.h"
#include "map/sheet/picture.h"

namespace thiessen {
namespace {

int foot(const PageStyle& style, PlotSheet::Margins margins) {
  if (style.bare) return 0;
  return style.ems(margins == PlotSheet::Margins::for_axes ? 3.6 : 2.2);
}

/// The part of the page in which the panel has room. A height of 0 is chosen by the panel's aspect.
PixelBox room_on(const PageStyle& style, double aspect, PlotSheet::Margins margins,
                 const PlotSize& size) {
  const bool has_axes = margins == PlotSheet::Margins::for_axes;
  const int left = style.bare ? 0 : has_axes ? style.ems(5.2) : style.em;
  const int top = style.bare ? 0 : style.ems(3.2);
  const int across = size.width - left - (style.bare ? 0 : style.ems(1.4));
  const int down = size.height > 0 ? size.height - top - foot(style, margins)
                                   : static_cast<int>(std::lround(across / std::max(aspect, 1.0)));
  return {left, top, across, std::max(down, 1)};
}

/// The largest box of this aspect in the middle of the room.
PixelBox panel_in(const PixelBox& room, double aspect) {
  int width = room.width;
  int height = std::max(1, static_cast<int>(std::lround(width / aspect)));
  if (height > room.height) {
    height = room.height;
    width = std::clamp(static_cast<int>(std::lround(height * aspect)), 1, room.width);
  }
  return {room.x + (room.width - width) / 2, room.y + (room.height - height) / 2, width, height};
}

}  // namespace

PlotSheet::PlotSheet(double aspect, Margins margins, const PlotSize& size)
    : style_(page_style(size.width, size.height, size.dots_to_the_inch)),
      room_(room_on(style_, aspect, margins, size)),
      panel_(panel_in(room_, aspect)),
      canvas_(size.width, size.height > 0 ? size.height : room_.bottom() + foot(style_, margins)),
      note_left_(style_.em) {}

double PlotSheet::aspect_of_room(Margins margins, const PlotSize& size) {
  const PageStyle style = page_style(size.width, size.height, size.dots_to_the_inch);
  const PixelBox room = room_on(style, 1, margins, size);
  return static_cast<double>(room.width) / room.height;
}

void PlotSheet::write(const SetText& text, int x, int baseline, Align align, Colour colour) {
  if (align == Align::centre) x -= text.width() / 2;
  if (align == Align::right) x -= text.width();
  canvas_.text(text, x, baseline - text.baseline, {colour});
}

void PlotSheet::write_legend(std::size_t in_sight, std::size_t points) {
  if (style_.bare) return;
  const int size = style_.ems(0.9);
  const int length = style_.ems(3);
  const double thickness = 0.09 * style_.em;
  const int middle = style_.ems(1.2);
  const int baseline = middle + style_.ems(0.32);
  int x = room_.x;
  const auto line = [&](const char* name, Colour colour, bool dashed) {
    const double y = middle + style_.em % 2 / 2.0;
    const std::array<Point, 2> ends{Point{x + thickness, y}, Point{x + length - thickness, y}};
    const Polyline whole(ends);
    const double dash = dashed ? 0.45 * style_.em : 0;
    canvas_.lines({&whole, 1}, {colour, thickness, 255, dash, 0.4 * style_.em},
                  {{x, middle - style_.em / 2, length, style_.em}, {0, 0}});
    const SetText text = type_.set(name, size);
    write(text, x + length + style_.ems(0.5), baseline, Align::left, ink::text);
    x += length + style_.ems(2.2) + text.width();
  };
  line("Voronoi", ink::voronoi, false);
  line("Delaunay", ink::delaunay, true);
  const Point dot{x + style_.ems(0.3) + 0.5, middle + 0.5};
  canvas_.disc(dot, 0.24 * style_.em, ink::text, {0, 0, canvas_.width(), room_.y});
  const std::string all = points == 0   ? "no points"
                          : points == 1 ? "1 point"
                                        : std::to_string(points) + " points";
  const std::string count = in_sight < points ? std::to_string(in_sight) + " of " + all : all;
  write(type_.set(count, size), x + style_.em, baseline, Align::left, ink::text);
}

void PlotSheet::write_note(const std::string& note) {
  if (style_.bare) return;
  const int room = room_.right() - note_left_;
  const SetText text = type_.fit(note, style_.ems(0.72), style_.ems(0.6), room);
  write(text, note_left_, canvas_.height() - style_.ems(0.7), Align::left, ink::quiet_text);
  note_left_ += text.width() + style_.ems(2);
}

void PlotSheet::write_sentence(std::string_view sentence) {
  if (style_.bare) return;
  const SetText text =
      type_.fit(sentence, style_.ems(1.1), style_.ems(0.7), panel_.width - 2 * style_.em);
  write(text, panel_.x + panel_.width / 2, panel_.y + panel_.height / 2, Align::centre,
        ink::quiet_text);
}

void PlotSheet::draw_border() {
  canvas_.border(panel_, ink::border, style_.hairline);
}

}  // namespace thiessen
