#include "map/plot/plane_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "map/ink/ink.h"
#include "map/plot/axis_ticks.h"
#include "map/plot/box_cut.h"
#include "map/plot/number_labels.h"
#include "map/plot/plot_sheet.h"
#include "map/plot/tessellation_edges.h"
#include "map/sheet/ticks.h"

namespace thiessen {
namespace {

constexpr int smallest_numerals = 11;

/// The points that lie in the panel, its border included.
std::vector<PointId> points_in_sight(const Tessellation<2>& tessellation, const PlanePlot& plot) {
  std::vector<PointId> points;
  tessellation.for_each_point([&](PointId p) {
    if (is_in_box<2>(plot.scene()(tessellation.position(p)), plot.half())) points.push_back(p);
  });
  return points;
}

/// The part of the edge that lies in the panel; none where it passes by.
std::optional<EdgeIn<2>> cut_to_panel(const EdgeIn<2>& edge, const CoordinatesIn<2>& half) {
  const Line<2> line{edge.from, {edge.to[0] - edge.from[0], edge.to[1] - edge.from[1]}};
  const auto seen = cut_to_box<2>(line, {0, 1}, half);
  if (!seen) return std::nullopt;
  return EdgeIn<2>{seen->from > 0 ? line.at(seen->from) : edge.from,
                   seen->to < 1 ? line.at(seen->to) : edge.to};
}

/// Sizes, in pixels, that suit the distance between the points.
struct Strokes {
  double voronoi;
  double delaunay;
  double dash;
  double gap;
  double dot;
  int numerals;

  /// `apart` is the rough distance from point to point, in pixels.
  Strokes(double apart, int em)
      : voronoi(std::clamp(0.4 + 0.02 * apart, 0.45, 0.09 * em)),
        delaunay(std::clamp(0.3 + 0.018 * apart, 0.35, 0.075 * em)),
        dash(std::clamp(0.12 * apart, 3.0, 0.45 * em)),
        gap(std::clamp(0.08 * apart, 2.5, 0.3 * em) + delaunay),
        dot(std::clamp(0.065 * apart, 0.7, 0.24 * em)),
        numerals(std::clamp(static_cast<int>(0.3 * apart), smallest_numerals, (9 * em) / 10)) {}
};

CoordinatesIn<2> stretch_of(const CoordinateRange<2>& range) {
  CoordinatesIn<2> stretch{1, 1};
  const double longest = range.longest_side();
  for (std::size_t i = 0; i < 2; ++i) {
    const double side = range.side(i);
    if (side > 0 && side * PlanePlot::longest_shown < longest) stretch[i] = longest / side / 3;
  }
  return stretch;
}

class PlaneDrawing {
 public:
  PlaneDrawing(const Tessellation<2>& tessellation, const PlanePlot& plot, const PlotSize& size)
      : tessellation_(tessellation),
        plot_(plot),
        sheet_(plot.aspect(), PlotSheet::Margins::for_axes, size),
        in_sight_(points_in_sight(tessellation, plot)),
        strokes_(apart(), sheet_.style().em) {}

  void draw(const NumberOf& number_of) {
    draw_edges();
    sheet_.draw_border();
    const bool has_text = !sheet_.style().bare;
    if (has_text) draw_axes();
    draw_dots();
    if (has_text) write_numbers(number_of);
    if (!has_text) return;
    sheet_.write_legend(in_sight_.size(), tessellation_.count());
    write_notes();
  }
  PixelCanvas take_canvas() { return std::move(sheet_.canvas()); }

 private:
  double apart() const {
    const PixelBox& panel = sheet_.panel();
    const double pixels = static_cast<double>(panel.width) * panel.height;
    return std::sqrt(pixels / 2 / static_cast<double>(std::max<std::size_t>(in_sight_.size(), 1)));
  }
  Point dot_of(PointId p) const {
    return plot_.pixel(plot_.scene()(tessellation_.position(p)), sheet_.panel());
  }

  using Segment = std::array<Point, 2>;

  std::vector<Segment> segments(const std::vector<EdgeIn<2>>& edges) const {
    std::vector<Segment> result;
    result.reserve(edges.size());
    for (const EdgeIn<2>& whole : edges) {
      const auto edge = cut_to_panel(whole, plot_.half());
      if (!edge) continue;
      result.push_back(
          {plot_.pixel(edge->from, sheet_.panel()), plot_.pixel(edge->to, sheet_.panel())});
    }
    return result;
  }

  void draw_edges() {
    const auto edges = edges_in_box(tessellation_, plot_.scene(), plot_.half());
    const auto draw = [&](const std::vector<EdgeIn<2>>& some, const Stroke& stroke) {
      const std::vector<Segment> ends = segments(some);
      const std::vector<Polyline> lines(ends.begin(), ends.end());
      sheet_.canvas().lines(lines, stroke, {sheet_.panel(), {0, 0}});
    };
    draw(edges.delaunay, {ink::delaunay, strokes_.delaunay, 255, strokes_.dash, strokes_.gap});
    draw(edges.voronoi, {ink::voronoi, strokes_.voronoi});
  }

  double rim() const { return strokes_.dot < 2 ? strokes_.dot : 1.3 * strokes_.dot + 0.3; }

  /// Draws dots whole, over the border too: a point on it is in sight.
  void draw_dots() {
    const PixelBox& panel = sheet_.panel();
    const int reach = static_cast<int>(std::ceil(rim()));
    const PixelBox clip{panel.x - reach, panel.y - reach, panel.width + 2 * reach,
                        panel.height + 2 * reach};
    const auto all_discs = [&](double radius, Colour colour) {
      for (const PointId p : in_sight_) {
        throw_if_interrupted();
        sheet_.canvas().disc(dot_of(p), radius, colour, clip);
      }
    };
    if (rim() > strokes_.dot) all_discs(rim(), ink::white);
    all_discs(strokes_.dot, ink::text);
  }

  struct Numbered {
    std::uint64_t number;
    Point dot;
  };

  void write_numbers(const NumberOf& number_of) {
    // Pixels. Where points are closer together, numbers would hide all else.
    constexpr double least_apart = 26;
    if (apart() < least_apart) {
      notes_.push_back("too many points to number");
      return;
    }
    NumberLabels labels(sheet_.canvas(), sheet_.panel(), sheet_.type(), strokes_.numerals);
    std::vector<Numbered> points;
    for (const PointId p : in_sight_) {
      points.push_back({number_of(p), dot_of(p)});
      labels.keep_clear(points.back().dot, strokes_.dot);
    }
    std::sort(points.begin(), points.end(),
              [](const Numbered& a, const Numbered& b) { return a.number < b.number; });
    std::size_t written = 0;
    const Colour colour = strokes_.numerals > smallest_numerals ? ink::text : ink::quiet_text;
    for (const Numbered& point : points) {
      if (labels.write(point.number, point.dot, rim(), colour)) ++written;
    }
    if (written < points.size()) {
      notes_.push_back("numbered: " + std::to_string(written) + " of " +
                       std::to_string(points.size()));
    }
  }

  AxisTicks ticks_along(std::size_t axis, int pixels, double ems_apart) const {
    const double half = plot_.half()[axis];
    const SceneCoordinates<2>& scene = plot_.scene();
    return axis_ticks(scene.origin(axis), scene.unplaced(axis, -half), scene.unplaced(axis, half),
                      std::max(2, static_cast<int>(pixels / (ems_apart * sheet_.style().em))));
  }

  /// The place of a tick in pixels of the page.
  Point tick_pixel(std::size_t axis, const AxisTicks::Tick& tick) const {
    CoordinatesIn<2> place{};
    const SceneCoordinates<2>& scene = plot_.scene();
    place[axis] = (tick.at - scene.unplaced(axis, 0)) * scene.scale(axis);
    return plot_.pixel(place, sheet_.panel());
  }

  void draw_axes() {
    const PageStyle& style = sheet_.style();
    const PixelBox panel = sheet_.panel();
    const int size = style.ems(0.8);
    const int tick_length = style.ems(0.3);
    const AxisTicks x = ticks_along(0, panel.width, 6);
    for (const AxisTicks::Tick& tick : x.ticks) {
      const int at = static_cast<int>(std::floor(tick_pixel(0, tick).x));
      sheet_.canvas().fill({at, panel.bottom(), style.hairline, tick_length}, ink::border);
      const SetText text = sheet_.type().set(tick.text, size);
      const int middle = std::min(at, sheet_.canvas().width() - text.width() / 2 - style.hairline);
      sheet_.write(text, middle, panel.bottom() + style.ems(1.1), PlotSheet::Align::centre,
                   ink::text);
    }
    sheet_.write(sheet_.type().set(x.title('x'), size), panel.right(),
                 panel.bottom() + style.ems(2.2), PlotSheet::Align::right, ink::text);
    const AxisTicks y = ticks_along(1, panel.height, 3.5);
    for (const AxisTicks::Tick& tick : y.ticks) {
      const int at = static_cast<int>(std::floor(tick_pixel(1, tick).y));
      sheet_.canvas().fill({panel.x - tick_length, at, tick_length, style.hairline}, ink::border);
      const SetText text =
          sheet_.type().fit(tick.text, size, style.ems(0.5), panel.x - style.ems(0.8));
      sheet_.write(text, panel.x - style.ems(0.5), at + text.baseline - text.height() / 2,
                   PlotSheet::Align::right, ink::text);
    }
    const SetText name = sheet_.type().set(y.title('y'), size);
    sheet_.write(name, std::max(style.ems(0.6), panel.x - style.ems(0.5) - name.width()),
                 panel.y - style.ems(0.5), PlotSheet::Align::left, ink::text);
  }

  void write_notes() {
    if (tessellation_.span() == Span::line && tessellation_.count() > 2) {
      notes_.insert(notes_.begin(), "the points lie on one line");
    }
    for (const std::size_t axis : {0u, 1u}) {
      if (plot_.stretch(axis) == 1) continue;
      notes_.insert(notes_.begin(), std::string("not to scale: ") + (axis == 0 ? "x" : "y") +
                                        " is stretched " + round_below(plot_.stretch(axis)).text() +
                                        " times or more");
    }
    for (const std::string& note : notes_) sheet_.write_note(note);
  }

  const Tessellation<2>& tessellation_;
  const PlanePlot& plot_;
  PlotSheet sheet_;
  std::vector<PointId> in_sight_;
  Strokes strokes_;
  std::vector<std::string> notes_;
};

}  // namespace

PlanePlot::PlanePlot(const CoordinateRange<2>& range, Surroundings surroundings)
    : stretch_(stretch_of(range)), scene_(range, stretch_), half_(scene_.half()) {
  if (surroundings == Surroundings::none) return;
  constexpr double margin = 0.14;
  constexpr double least_aspect = 1;
  constexpr double largest_aspect = 2.4;
  half_ = {scene_.half()[0] + margin, scene_.half()[1] + margin};
  if (range.longest_side() == 0) half_ = {1, 1 / 1.5};
  half_[0] = std::max(half_[0], least_aspect * half_[1]);
  half_[1] = std::max(half_[1], half_[0] / largest_aspect);
}

PlanePlot PlanePlot::of_window(const PlaneWindow& window) {
  CoordinateRange<2> range;
  range.low = coordinates(window.low);
  range.high = coordinates(window.high);
  return {range, Surroundings::none};
}

void PlanePlot::widen_to(double aspect) {
  half_[0] = std::max(half_[0], aspect * half_[1]);
  half_[1] = std::max(half_[1], half_[0] / aspect);
}

Point PlanePlot::pixel(const CoordinatesIn<2>& place, const PixelBox& panel) const {
  const double scale = panel.width / (2 * half_[0]);
  return {panel.x + panel.width / 2.0 + place[0] * scale,
          panel.y + panel.height / 2.0 - place[1] * scale};
}

PixelCanvas plot_plane(const Tessellation<2>& tessellation, const NumberOf& number_of,
                       const std::optional<PlaneWindow>& window, const PlotSize& size) {
  if (tessellation.empty()) {
    const bool is_tall = size.height > 0;
    constexpr auto plain = PlotSheet::Margins::plain;
    PlotSheet sheet(is_tall ? PlotSheet::aspect_of_room(plain, size) : 1.5, plain, size);
    sheet.draw_border();
    sheet.write_legend(0, 0);
    sheet.write_sentence("There are no points, and so there is nothing to tessellate.");
    return std::move(sheet.canvas());
  }
  PlanePlot plot =
      window ? PlanePlot::of_window(*window) : PlanePlot(CoordinateRange<2>(tessellation));
  if (!window && size.height > 0)
    plot.widen_to(PlotSheet::aspect_of_room(PlotSheet::Margins::for_axes, size));
  PlaneDrawing drawing(tessellation, plot, size);
  drawing.draw(number_of);
  return drawing.take_canvas();
}

}  // namespace thiessen
