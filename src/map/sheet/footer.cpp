#include "map/sheet/footer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "map/ink/ink.h"
#include "map/ink/scanline.h"
#include "map/ink/stroke.h"

namespace thiessen {
namespace {

/// Draws the scale bar with its figures, and returns the x of its right end, figures included.
int draw_scale_bar(Canvas& canvas, const Page& page, const StudyView& view, double pixels_per_unit,
                   Typesetter& type) {
  const PixelBox& foot = page.footer;
  const int em = page.style.em;
  const double longest = std::min(foot.width * 0.3, 16.0 * em);
  const ScaleBar bar = scale_bar(pixels_per_unit, view.projection.metres_per_unit(), longest);
  if (!(bar.pixels >= 1)) return foot.x;
  const int size = page.style.ems(0.8);
  const SetText zero = type.set("0", size);
  const int left = foot.x + zero.width() / 2 + 1;
  const int top = foot.y + page.style.ems(0.9);
  const int height = std::max(3, em / 3);
  const int full = static_cast<int>(std::lround(bar.pixels));
  const int half = static_cast<int>(std::lround(bar.pixels / 2));
  const PixelBox outline{left, top, full, height};
  canvas.fill(outline, ink::white);
  canvas.fill({left, top, half, height}, ink::text);
  canvas.border(outline, ink::text, page.style.hairline);

  constexpr double wide_area = 0.15;  // radians: the scale varies by a hundredth within
  std::string end = bar.length.text();
  const SetText number = type.set(end, size);
  end += " " + bar.unit + (view.radius > wide_area ? " at the map's centre" : "");
  const SetText last = type.set(end, size);
  const RoundValue middle{bar.length.digits * 5, bar.length.exponent - 1};
  const SetText halfway = type.set(middle.text(), size);
  const int baseline = top + height + page.style.ems(1.0);
  const auto put = [&](const SetText& text, int x) {
    canvas.blend(x, baseline - text.baseline, text.ink, ink::text);
  };
  put(zero, left - zero.width() / 2);
  put(last, left + full - number.width() / 2);
  if (half > zero.width() + halfway.width() / 2 + number.width() / 2 + em) {
    put(halfway, left + half - halfway.width() / 2);
  }
  return left + full - number.width() / 2 + last.width();
}

/// Draws an arrow with an N over it, its left edge at `x`, and returns the x of its right edge.
int draw_north_arrow(Canvas& canvas, const Page& page, int x, Typesetter& type) {
  const PageStyle& style = page.style;
  const int width = style.ems(1.0);
  const int top = page.footer.y + style.ems(0.6);
  const int height = style.ems(1.5);
  const SetText letter = type.set("N", style.ems(0.8), Weight::bold);
  const double middle = width / 2.0;
  const double foot = height;
  const double notch = height * 0.72;
  OwnerRaster raster(width, height);
  const std::array<Ring, 2> halves{Ring{{middle, 0}, {0, foot}, {middle, notch}},
                                   Ring{{middle, 0}, {middle, notch}, {1.0 * width, foot}}};
  raster.fill(std::span(halves).first(1), 0);
  Coverage outline(width + 2, height + 2);
  for (const Ring& half : halves) {
    for (std::size_t i = 0; i < half.size(); ++i) {
      const Point a = half[i];
      const Point b = half[(i + 1) % half.size()];
      stroke(outline, {a.x + 1, a.y + 1}, {b.x + 1, b.y + 1}, style.hairline);
    }
  }
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (raster.at(column, row) == 0) canvas.set(x + column, top + row, ink::text);
    }
  }
  canvas.blend(x - 1, top - 1, outline, ink::text);
  canvas.blend(x + (width - letter.width()) / 2, top + height + style.ems(0.25), letter.ink,
               ink::text);
  return x + width;
}

}  // namespace

ScaleBar scale_bar(double pixels_per_unit, double metres_per_unit, double longest) {
  constexpr double kilometre = 1000;
  ScaleBar bar;
  const bool known = std::isfinite(metres_per_unit) && metres_per_unit > 0;
  const double pixels_per_metre = known ? pixels_per_unit / metres_per_unit : pixels_per_unit;
  const double metres = longest / pixels_per_metre;
  if (!std::isfinite(metres) || metres <= 0) return bar;
  const bool kilometres = known && metres >= kilometre;
  bar.unit = kilometres ? "km" : known ? "m" : "units";
  const double metres_per_bar_unit = kilometres ? kilometre : 1;
  bar.length = round_below(metres / metres_per_bar_unit);
  bar.pixels = bar.length.value() * metres_per_bar_unit * pixels_per_metre;
  return bar;
}

void draw_footer(Canvas& canvas, const Page& page, const StudyView& view, double pixels_per_unit,
                 bool north_is_up, const std::string& labels_note, Typesetter& type) {
  const PageStyle& style = page.style;
  if (page.footer.height == 0) return;
  int left = draw_scale_bar(canvas, page, view, pixels_per_unit, type) + style.ems(1.5);
  constexpr double nearly_pole = 89;
  const bool is_plane = view.projection.kind() == MapProjection::Kind::plane;
  const bool has_north =
      is_plane ? north_is_up : std::abs(view.projection.centre().y) < nearly_pole;
  if (has_north) left = draw_north_arrow(canvas, page, left, type) + style.ems(1.5);
  const int right = page.footer.x + page.footer.width;
  int baseline = page.footer.y + style.ems(1.3);
  for (const std::string& note : {labels_note, view.projection.name()}) {
    if (note.empty()) continue;
    const SetText text = type.set(note, style.ems(0.72));
    if (text.width() > right - left) continue;
    canvas.blend(right - text.width(), baseline - text.baseline, text.ink, ink::quiet_text);
    baseline += style.ems(1.1);
  }
}

}  // namespace thiessen
