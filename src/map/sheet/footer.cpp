#include "map/sheet/footer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "map/ink/ink.h"

namespace thiessen {
namespace {

/// Draws the scale bar with its figures, and returns the x of its right end, figures included.
int draw_scale_bar(Canvas& canvas, const Page& page, const StudyView& view, double pixels_per_unit,
                   Typesetter& type) {
  const PixelBox& foot = page.footer;
  const int em = page.style.em;
  const double longest = std::min({foot.width * 0.3, page.panel.width * 0.6, 16.0 * em});
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
  // The figure of a bar with no room for two stands below all of it.
  const bool is_short = full < zero.width() / 2 + number.width() / 2 + em / 2;
  const RoundValue middle{bar.length.digits * 5, bar.length.exponent - 1};
  const SetText halfway = type.set(middle.text(), size);
  const int baseline = top + height + page.style.ems(1.0);
  const auto put = [&](const SetText& text, int x) {
    canvas.text(text, x, baseline - text.baseline, {ink::text});
  };
  if (is_short) {
    put(last, left);
    return left + std::max(full, last.width());
  }
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
  const Ring left{{middle, 0}, {0, foot}, {middle, notch}};
  const Ring right{{middle, 0}, {middle, notch}, {1.0 * width, foot}};
  const Window window{{x - 1, top - 1, width + 2, height + 2},
                      {static_cast<double>(x), static_cast<double>(top)}};
  const Area dark{{{&left, 1}}, ink::text};
  canvas.areas({&dark, 1}, {}, window);
  std::vector<Ring> outlines{left, right};
  for (Ring& outline : outlines) outline.push_back(outline.front());
  const std::vector<Polyline> lines(outlines.begin(), outlines.end());
  canvas.lines(lines, {ink::text, static_cast<double>(style.hairline)}, window);
  canvas.text(letter, x + (width - letter.width()) / 2, top + height + style.ems(0.25),
              {ink::text});
  return x + width;
}

/// Whether north is up on all of the map, more or less. Where the pole lies on it, it is not.
bool has_north_above(const StudyView& view, bool north_is_up) {
  constexpr double radian = std::numbers::pi / 180;
  switch (view.projection.kind()) {
    case MapProjection::Kind::plane:
      return north_is_up;
    case MapProjection::Kind::stereographic:
      return (90 - std::abs(view.projection.centre().y)) * radian > view.radius;
    case MapProjection::Kind::plate_carree:
      return true;
  }
  return true;
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

std::vector<std::string> draw_footer(Canvas& canvas, const Page& page, const StudyView& view,
                                     double pixels_per_unit, bool north_is_up,
                                     const std::string& labels_note, Typesetter& type) {
  const PageStyle& style = page.style;
  if (page.footer.height == 0) return {};
  int left = draw_scale_bar(canvas, page, view, pixels_per_unit, type) + style.ems(1.5);
  if (has_north_above(view, north_is_up))
    left = draw_north_arrow(canvas, page, left, type) + style.ems(1.5);
  const int right = page.footer.x + page.footer.width;
  int baseline = page.footer.y + style.ems(1.3);
  std::vector<std::string> without_room;
  for (const std::string& note : {labels_note, view.projection.name()}) {
    if (note.empty()) continue;
    const SetText text = type.set(note, style.ems(0.72));
    if (text.width() > right - left) {
      without_room.push_back(note);
      continue;
    }
    canvas.text(text, right - text.width(), baseline - text.baseline, {ink::quiet_text});
    baseline += style.ems(1.1);
  }
  return without_room;
}

}  // namespace thiessen
