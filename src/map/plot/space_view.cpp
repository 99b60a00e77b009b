#include "map/plot/space_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "map/ink/ink.h"
#include "map/plot/camera.h"
#include "map/plot/depth_drawing.h"
#include "map/plot/number_labels.h"
#include "map/plot/plot_sheet.h"
#include "map/plot/scene_box.h"
#include "map/plot/tessellation_edges.h"
#include "map/sheet/ticks.h"

namespace thiessen {
namespace {

/// The panel's aspect where no height of the page is given.
constexpr double usual_aspect = 1.35;

PlotSheet sheet_of(const PlotSize& size) {
  constexpr auto plain = PlotSheet::Margins::plain;
  return {size.height > 0 ? PlotSheet::aspect_of_room(plain, size) : usual_aspect, plain, size};
}

/// The place and the direction of the look, in units of the scene.
struct Sight {
  SceneVector eye;
  SceneVector direction;
};

Sight default_sight(const SceneVector& half) {
  constexpr double degree = 0.017453292519943295;
  constexpr double azimuth = -58 * degree;
  constexpr double elevation = 24 * degree;
  const SceneVector outward{std::cos(elevation) * std::cos(azimuth),
                            std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
  return {4.2 * length(half) * outward, -1 * outward};
}

void check(const View& view) {
  for (const SpacePoint& p : {view.view, view.site}) {
    for (const double c : coordinates(p)) {
      if (!std::isfinite(c)) throw Error(Message{{}, 0, "the view is not finite", {}});
    }
  }
  if (view.view == view.site) {
    throw Error(Message{{},
                        0,
                        "view and site are the same point, so there is no way to look",
                        "give two different points"});
  }
}

/// The eye and the direction of the look. The direction comes from the points' own coordinates, so
/// that it is right however close together view and site are against the points' range.
Sight sight_of(const View& view, const SceneCoordinates<3>& scene) {
  constexpr double beside = 10;         // in units of the scene
  constexpr double far_enough = 20000;  // a view from farther away looks the same
  SceneVector step{view.site.x - view.view.x, view.site.y - view.view.y, view.site.z - view.view.z};
  const double largest = std::max({std::abs(step[0]), std::abs(step[1]), std::abs(step[2])});
  for (double& c : step) c /= largest;
  const SceneVector direction = unit(step);
  const SceneVector site = scene(view.site);
  SceneVector eye = scene(view.view);
  if (!std::isfinite(largest) || !std::isfinite(length(eye))) {
    throw Error(Message{{}, 0, "the view is too far from the points to be drawn", {}});
  }
  if (length(site) < beside && length(site - eye) > far_enough) {
    eye = site - far_enough * direction;
  }
  return {eye, direction};
}

class SpaceDrawing {
 public:
  SpaceDrawing(const Tessellation<3>& tessellation, const std::optional<View>& view,
               const PlotSize& size)
      : tessellation_(tessellation),
        scene_(CoordinateRange<3>(tessellation), {1, 1, 1}),
        half_(half_of_box()),
        sight_(view ? sight_of(*view, scene_) : default_sight(half_)),
        sheet_(sheet_of(size)),
        camera_(sight_.eye, sight_.direction, half_, sheet_.panel(),
                view ? Camera::Middle::straight_ahead : Camera::Middle::box),
        drawing_(camera_, sheet_.panel()) {}

  void draw(const NumberOf& number_of, const std::optional<View>& view) {
    sheet_.write_legend(tessellation_.count(), tessellation_.count());
    const SceneBox box(scene_, half_, camera_, sight_.eye);
    box.add_edges(drawing_, {ink::border, hairline(), 0, 0, 0});
    add_edges();
    add_balls();
    drawing_.draw(sheet_.canvas());
    const bool has_text = !sheet_.style().bare;
    if (camera_.is_outside() && has_text) box.write_coordinates(sheet_);
    if (camera_.sees_box()) {
      if (has_text) write_numbers(number_of);
    } else {
      sheet_.write_sentence("None of the points lies ahead.");
    }
    sheet_.draw_border();
    if (has_text) write_notes(view);
  }
  PixelCanvas take_canvas() { return std::move(sheet_.canvas()); }

 private:
  SceneVector half_of_box() const {
    constexpr double margin = 0.26;
    SceneVector half = scene_.half();
    const bool is_point = length(half) == 0;
    for (double& side : half) side += is_point ? 0.5 : margin;
    return half;
  }

  double hairline() const { return sheet_.style().hairline; }
  int em() const { return sheet_.style().em; }
  /// The rough distance from point to point, in units of the scene.
  double apart() const { return std::cbrt(1 / static_cast<double>(tessellation_.count())); }
  /// The factor by which lines are thinned: 1 for few points, less for many.
  double fineness() const { return std::clamp(apart() / 0.3, 0.3, 1.0); }

  void add_edges() {
    const auto edges = edges_in_box(tessellation_, scene_, half_);
    const double em = this->em();
    const double fine = fineness();
    const double casing = fine * 0.12 * em;
    const Pen red{ink::voronoi, fine * 0.1 * em, 0, 0, casing};
    const Pen thin_red{ink::voronoi, 0.05 * em, 0, 0, 0};
    const Pen blue{ink::delaunay, fine * 0.085 * em, fine * 0.45 * em, fine * 0.4 * em, casing};
    for (const EdgeIn<3>& edge : edges.delaunay) add_between_balls(edge, blue);
    for (const EdgeIn<3>& edge : edges.voronoi) drawing_.add_line(edge.from, edge.to, red);
    if (edges.voronoi.empty() && tessellation_.span() == Span::space) {
      notes_.push_back("no Voronoi edge comes into the box");
    }
    for (const EdgeIn<3>& edge : edges.rims) drawing_.add_line(edge.from, edge.to, thin_red);
  }

  void add_between_balls(const EdgeIn<3>& edge, const Pen& pen) {
    const SceneVector whole = edge.to - edge.from;
    const double covered = ball_radius() / length(whole);
    if (covered >= 0.5) return;
    drawing_.add_line(edge.from + covered * whole, edge.to - covered * whole, pen);
  }

  double ball_radius() const { return std::min(0.016, 0.06 * apart()); }

  void add_balls() {
    tessellation_.for_each_point([&](PointId p) {
      drawing_.add_ball(scene_(tessellation_.position(p)), ball_radius(), 0.9, 1.2 * em(),
                        ink::text);
    });
  }

  struct Numbered {
    std::uint64_t number;
    Point dot;
    double ahead;
  };

  void write_numbers(const NumberOf& number_of) {
    constexpr std::size_t most = 300;
    if (tessellation_.count() > most) {
      notes_.push_back("too many points to number");
      return;
    }
    const bool few = tessellation_.count() <= 60;
    NumberLabels labels(sheet_.canvas(), sheet_.panel(), sheet_.type(),
                        sheet_.style().ems(few ? 0.8 : 0.6));
    std::vector<Numbered> points;
    tessellation_.for_each_point([&](PointId p) {
      const SceneVector seen = camera_.seen(scene_(tessellation_.position(p)));
      if (seen[2] < camera_.near_plane()) return;
      const Point dot = camera_.pixel(seen);
      const PixelBox& panel = sheet_.panel();
      if (dot.x < panel.x || dot.x > panel.right() || dot.y < panel.y || dot.y > panel.bottom()) {
        return;
      }
      points.push_back({number_of(p), dot, seen[2]});
      labels.keep_clear(dot, radius(seen[2]));
    });
    std::sort(points.begin(), points.end(), [](const Numbered& a, const Numbered& b) {
      return std::pair(a.ahead, a.number) < std::pair(b.ahead, b.number);
    });
    std::size_t written = 0;
    for (const Numbered& point : points) {
      const Colour colour = drawing_.faded(ink::text, (camera_.nearest() + point.ahead) / 2);
      if (labels.write(point.number, point.dot, radius(point.ahead) + 1, colour)) ++written;
    }
    if (points.size() < tessellation_.count()) {
      notes_.push_back("points in sight: " + std::to_string(points.size()));
    }
    if (written < points.size()) {
      notes_.push_back("numbered: " + std::to_string(written) + " of " +
                       std::to_string(points.size()));
    }
  }

  double radius(double ahead) const {
    return std::clamp(ball_radius() * camera_.pixels_per_unit(ahead), 0.9, 1.2 * em());
  }

  /// Writes a place of the scene in the points' own coordinates, to a hundredth of their range or
  /// so.
  std::string text_of(const SceneVector& place) const {
    std::string text = "(";
    for (std::size_t i = 0; i < 3; ++i) {
      const int exponent = static_cast<int>(std::floor(std::log10(1 / scene_.scale(i)))) - 2;
      const double value = scene_.unplaced(i, place[i]) + scene_.origin(i);
      const double steps = value / RoundValue{1, exponent}.value();
      constexpr double whole = 9e15;
      if (i > 0) text += ", ";
      text += std::abs(steps) < whole ? decimal_text(std::llround(steps), exponent)
                                      : shortest_text(value);
    }
    return text + ")";
  }

  static std::string text_of(const SpacePoint& p) {
    return "(" + shortest_text(p.x) + ", " + shortest_text(p.y) + ", " + shortest_text(p.z) + ")";
  }

  void write_notes(const std::optional<View>& view) {
    const std::string from = view ? text_of(view->view) : text_of(sight_.eye);
    const std::string to = view ? text_of(view->site) : text_of(SceneVector{0, 0, 0});
    sheet_.write_note("seen from " + from + " towards " + to);
    if (tessellation_.span() == Span::line) {
      sheet_.write_note("the points lie on one line: Voronoi cells are slabs");
    }
    if (tessellation_.span() == Span::plane) {
      sheet_.write_note("the points lie in one plane: Voronoi cells are prisms");
    }
    if (!camera_.is_outside()) {
      sheet_.write_note("box from " + text_of(-1 * half_) + " to " + text_of(half_));
    }
    for (const std::string& note : notes_) sheet_.write_note(note);
  }

  const Tessellation<3>& tessellation_;
  SceneCoordinates<3> scene_;
  SceneVector half_;
  Sight sight_;
  PlotSheet sheet_;
  Camera camera_;
  DepthDrawing drawing_;
  std::vector<std::string> notes_;
};

}  // namespace

PixelCanvas view_space(const Tessellation<3>& tessellation, const NumberOf& number_of,
                       const std::optional<View>& view, const PlotSize& size) {
  if (view) check(*view);
  if (tessellation.empty()) {
    PlotSheet sheet = sheet_of(size);
    sheet.draw_border();
    sheet.write_legend(0, 0);
    sheet.write_sentence("There are no points, and so there is nothing to tessellate.");
    return std::move(sheet.canvas());
  }
  SpaceDrawing drawing(tessellation, view, size);
  drawing.draw(number_of, view);
  return drawing.take_canvas();
}

}  // namespace thiessen
