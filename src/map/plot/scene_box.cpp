#include "map/plot/scene_box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "map/ink/ink.h"
#include "map/plot/axis_ticks.h"

namespace thiessen {
namespace {

constexpr std::array<double, 2> signs{-1, 1};

bool is_inside(const PixelBox& panel, double x, double y) {
  return panel.x < x && x < panel.right() && panel.y < y && y < panel.bottom();
}

/// Writes a text with its middle at a place, moved outward until the text is clear of the place;
/// writes nothing where the text would leave the panel.
void write_beyond(PlotSheet& sheet, const SetText& text, Point at, Point outward, double away,
                  Colour colour) {
  const double x = at.x + outward.x * (away + text.width() / 2.0);
  const double y = at.y + outward.y * (away + text.height() / 2.0);
  const double across = text.width() / 2.0 + 1;
  const double up = text.height() / 2.0 + 1;
  if (!is_inside(sheet.panel(), x - across, y - up) ||
      !is_inside(sheet.panel(), x + across, y + up)) {
    return;
  }
  sheet.write(text, static_cast<int>(std::lround(x)),
              static_cast<int>(std::lround(y - text.height() / 2.0)) + text.baseline,
              PlotSheet::Align::centre, colour);
}

}  // namespace

SceneBox::Edge SceneBox::edge(std::size_t axis, double sign_of_next, double sign_of_last) const {
  SceneVector from{};
  from[axis] = -half_[axis];
  from[(axis + 1) % 3] = sign_of_next * half_[(axis + 1) % 3];
  from[(axis + 2) % 3] = sign_of_last * half_[(axis + 2) % 3];
  SceneVector to = from;
  to[axis] = half_[axis];
  return {axis, from, to};
}

void SceneBox::add_edges(DepthDrawing& drawing, const Pen& pen) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double next : signs) {
      for (const double last : signs) {
        const Edge e = edge(axis, next, last);
        drawing.add_line(e.from, e.to, pen);
      }
    }
  }
}

// An edge is on the outline where one of its two faces is seen from outside and the other is not.
bool SceneBox::is_on_outline(const Edge& edge) const {
  const auto is_seen = [&](std::size_t axis) {
    return edge.from[axis] > 0 ? eye_[axis] > half_[axis] : eye_[axis] < -half_[axis];
  };
  return is_seen((edge.axis + 1) % 3) != is_seen((edge.axis + 2) % 3);
}

void SceneBox::write_coordinates(PlotSheet& sheet) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::optional<Edge> best;
    double best_rank = 0;
    for (const double next : signs) {
      for (const double last : signs) {
        const Edge e = edge(axis, next, last);
        if (!is_on_outline(e)) continue;
        const Point middle = camera_.pixel(camera_.seen(0.5 * (e.from + e.to)));
        const double rank = axis == 2 ? -middle.x : middle.y;  // z to the left, x and y below
        if (best && rank <= best_rank) continue;
        best = e;
        best_rank = rank;
      }
    }
    if (best) write_along(sheet, *best);
  }
}

void SceneBox::write_along(PlotSheet& sheet, const Edge& edge) const {
  const PageStyle& style = sheet.style();
  const Point from = camera_.pixel(camera_.seen(edge.from));
  const Point to = camera_.pixel(camera_.seen(edge.to));
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length < style.ems(4)) return;
  const Point centre = camera_.pixel(camera_.seen({0, 0, 0}));
  Point outward{(to.y - from.y) / length, (from.x - to.x) / length};
  const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
  if ((middle.x - centre.x) * outward.x + (middle.y - centre.y) * outward.y < 0) {
    outward = {-outward.x, -outward.y};
  }
  const double half = half_[edge.axis];
  const AxisTicks axis = axis_ticks(scene_.origin(edge.axis), scene_.unplaced(edge.axis, -half),
                                    scene_.unplaced(edge.axis, half),
                                    std::clamp(static_cast<int>(length / style.ems(4)), 2, 8));
  std::vector<std::array<Point, 2>> marks;
  double widest = 0;
  for (const AxisTicks::Tick& tick : axis.ticks) {
    SceneVector place = edge.from;
    place[edge.axis] = (tick.at - scene_.unplaced(edge.axis, 0)) * scene_.scale(edge.axis);
    const Point at = camera_.pixel(camera_.seen(place));
    if (!is_inside(sheet.panel(), at.x, at.y)) continue;
    const double mark = style.ems(0.3);
    marks.push_back({at, Point{at.x + mark * outward.x, at.y + mark * outward.y}});
    const SetText text = sheet.type().set(tick.text, style.ems(0.7));
    write_beyond(sheet, text, at, outward, style.ems(0.55), ink::quiet_text);
    widest =
        std::max(widest, std::abs(outward.x) * text.width() + std::abs(outward.y) * text.height());
  }
  const std::vector<Polyline> lines(marks.begin(), marks.end());
  sheet.canvas().lines(lines, {ink::quiet_text, static_cast<double>(style.hairline)},
                       {sheet.panel(), {0, 0}});
  write_beyond(sheet, sheet.type().set(axis.title("xyz"[edge.axis]), style.ems(0.85)), middle,
               outward, style.ems(1.0) + widest, ink::text);
}

}  // namespace thiessen
