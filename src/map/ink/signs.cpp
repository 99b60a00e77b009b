#include "map/ink/signs.h"

#include <algorithm>
#include <cmath>

#include "map/ink/contrast.h"
#include "map/ink/ink.h"

namespace thiessen {

double cell_line_width(int em) {
  return std::max(1.0, 0.055 * em);
}

double basin_line_width(int em) {
  return std::max(1.6, 0.13 * em);
}

double isohyet_line_width(int em) {
  return std::max(1.2, 0.085 * em);
}

Stroke cell_stroke(int em, Colour ground) {
  constexpr int dark = 200;
  constexpr int light = 140;  // as plain on the darkest ground as the other is on the palest
  const double by_dark = contrast(blended(ground, ink::cell_edge, dark), ground);
  const double by_light = contrast(blended(ground, ink::white, light), ground);
  const double width = cell_line_width(em);
  return by_light > by_dark ? Stroke{ink::white, width, light}
                            : Stroke{ink::cell_edge, width, dark};
}

Stroke basin_rim(int em, double width) {
  constexpr int alpha = 190;
  const double both_sides = std::min(width, 1.2 * cell_line_width(em));
  return {ink::white, width + both_sides, alpha};
}

bool hides_basin_edge(Colour ground) {
  constexpr double plain = 1.6;
  return contrast(ink::basin_edge, ground) < plain;
}

double gauge_radius(int em, std::size_t gauges, double pixels) {
  const double largest = 0.24 * em;
  const double apart = std::sqrt(pixels / std::max(1.0, static_cast<double>(gauges)));
  return std::max(1.2, std::min(largest, 0.12 * apart));
}

double gauge_reach(double radius) {
  return radius < 2 ? radius + 0.4 : radius * 1.3 + 0.3;
}

void draw_gauge(Canvas& canvas, Point centre, double radius, bool reports, const PixelBox& clip,
                const Mark& mark) {
  canvas.disc(centre, gauge_reach(radius), ink::white, clip);
  canvas.disc(centre, radius, ink::gauge, clip, mark);
  if (!reports) canvas.disc(centre, std::max(0.5, radius * 0.62), ink::white, clip);
}

}  // namespace thiessen
