#include "map/plot/depth_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "base/interrupt.h"
#include "map/ink/dashes.h"
#include "map/ink/ink.h"
#include "map/plot/box_cut.h"

namespace thiessen {
namespace {

/// The part of a line that lies ahead of the near plane.
std::optional<std::pair<SceneVector, SceneVector>> ahead_of(double near, SceneVector a,
                                                            SceneVector b) {
  if (a[2] < near && b[2] < near) return std::nullopt;
  const auto cut = [near](SceneVector& behind, const SceneVector& ahead) {
    if (behind[2] >= near) return;
    behind = behind + ((near - behind[2]) / (ahead[2] - behind[2])) * (ahead - behind);
    behind[2] = near;
  };
  cut(a, b);
  cut(b, a);
  return std::pair(a, b);
}

/// The part of the segment a→b that lies within `reach` of the panel, as shares of its length.
std::optional<Stretch> in_panel(const PixelBox& panel, Point a, Point b, double reach) {
  const Point middle{panel.x + panel.width / 2.0, panel.y + panel.height / 2.0};
  return cut_to_box<2>({{a.x - middle.x, a.y - middle.y}, {b.x - a.x, b.y - a.y}}, {0, 1},
                       {panel.width / 2.0 + reach, panel.height / 2.0 + reach});
}

std::vector<Dash> solid_pieces(double length) {
  constexpr double longest = 64;
  const double count = std::max(1.0, std::ceil(length / longest));
  std::vector<Dash> pieces;
  for (double i = 0; i < count; ++i) {
    pieces.push_back({i * length / count, (i + 1) * length / count});
  }
  return pieces;
}

Colour towards_white(Colour colour, double share) {
  const auto mix = [share](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::lround(value + share * (255 - value)));
  };
  return {mix(colour.red), mix(colour.green), mix(colour.blue)};
}

void draw_stroke(Canvas& canvas, const PixelBox& panel, Point from, Point to, double width,
                 Colour colour) {
  const std::array<Point, 2> ends{from, to};
  const Polyline line(ends);
  canvas.lines({&line, 1}, {colour, width}, {panel, {0, 0}});
}

}  // namespace

void DepthDrawing::add_line(const SceneVector& from, const SceneVector& to, const Pen& pen) {
  throw_if_interrupted();
  const auto ahead = ahead_of(camera_.near_plane(), camera_.seen(from), camera_.seen(to));
  if (!ahead) return;
  const auto& [a, b] = *ahead;
  const Point first = camera_.pixel(a);
  const Point last = camera_.pixel(b);
  const auto shown = in_panel(panel_, first, last, pen.width);
  const double length = std::hypot(last.x - first.x, last.y - first.y);
  if (!shown || length == 0) return;
  const auto at = [&](double share) {
    return Point{first.x + share * (last.x - first.x), first.y + share * (last.y - first.y)};
  };
  const double seen = (shown->to - shown->from) * length;
  for (const Dash& dash : pen.dash > 0 ? dashes(seen, pen.dash, pen.gap) : solid_pieces(seen)) {
    const double begin = shown->from + dash.from / length;
    const double end = shown->from + dash.to / length;
    const double middle = (begin + end) / 2;
    const double distance = 1 / ((1 - middle) / a[2] + middle / b[2]);
    const double thinner = 1 - 0.5 * depth(distance);
    pieces_.push_back({distance, at(begin), at(end), pen.width * thinner, pen.casing * thinner,
                       faded(pen.colour, distance), false});
  }
}

void DepthDrawing::add_ball(const SceneVector& centre, double radius, double least, double largest,
                            Colour colour) {
  const SceneVector seen = camera_.seen(centre);
  if (seen[2] < camera_.near_plane()) return;
  const double pixels = std::clamp(radius * camera_.pixels_per_unit(seen[2]), least, largest);
  const Point at = camera_.pixel(seen);
  pieces_.push_back({std::max(camera_.near_plane(), seen[2] - radius), at, at, 2 * pixels,
                     std::min(1.5, pixels / 3), faded(colour, seen[2]), true});
}

const std::vector<DepthDrawing::Piece>& DepthDrawing::in_order() {
  const auto key = [](const Piece& p) {
    return std::tuple(-p.ahead, p.is_ball, p.from, p.to, p.width, p.colour.red, p.colour.blue);
  };
  std::sort(pieces_.begin(), pieces_.end(), [&](const Piece& a, const Piece& b) {
    throw_if_interrupted();
    return key(a) < key(b);
  });
  return pieces_;
}

void DepthDrawing::draw(Canvas& canvas) {
  for (const Piece& piece : in_order()) {
    throw_if_interrupted();
    if (piece.is_ball) {
      draw_ball(canvas, piece);
    } else {
      draw_line(canvas, piece);
    }
  }
}

void DepthDrawing::draw_line(Canvas& canvas, const Piece& piece) const {
  const Point step{piece.to.x - piece.from.x, piece.to.y - piece.from.y};
  const double length = std::hypot(step.x, step.y);
  const double cased = piece.width + 2 * piece.casing;
  if (piece.casing > 0 && length > cased) {
    // The round ends of the casing stop at the ends of the line, so that they do not interrupt the
    // lines that it joins there.
    const double inset = cased / 2 / length;
    draw_stroke(canvas, panel_, Point{piece.from.x + inset * step.x, piece.from.y + inset * step.y},
                Point{piece.to.x - inset * step.x, piece.to.y - inset * step.y}, cased, ink::white);
  }
  draw_stroke(canvas, panel_, piece.from, piece.to, piece.width, piece.colour);
}

void DepthDrawing::draw_ball(Canvas& canvas, const Piece& piece) const {
  const double radius = piece.width / 2;
  canvas.disc(piece.from, radius + piece.casing, ink::white, panel_);
  canvas.disc(piece.from, radius, piece.colour, panel_);
  constexpr double smallest_shaded = 3;
  if (radius < smallest_shaded) return;
  for (const double share : {0.62, 0.36, 0.16}) {
    const double aside = 0.3 * radius * (1 - share / 2);
    canvas.disc({piece.from.x - aside, piece.from.y - aside}, share * radius,
                towards_white(piece.colour, 0.75 * (0.8 - share)), panel_);
  }
}

double DepthDrawing::depth(double ahead) const {
  constexpr double margin = 0.12;  // share of the box at either end, where no points are
  const double range = camera_.farthest() - camera_.nearest();
  if (!(range > 0)) return 0;
  const double share = (ahead - camera_.nearest()) / range;
  return std::clamp((share - margin) / (1 - 2 * margin), 0.0, 1.0);
}

Colour DepthDrawing::faded(Colour colour, double ahead) const {
  return towards_white(colour, 0.78 * depth(ahead));
}

}  // namespace thiessen
