#include "rainfall/normals/raster_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "basin/basin.h"
#include "earth/sphere/conformal_sphere.h"
#include "geometry/segment.h"

namespace thiessen {
namespace {

/// How far, in pixels, a piece of a curved edge may lie from its chord; and in a chart, whose edges
/// are drawn within a tenth of a metre.
constexpr double most_bent = 2e-5;
constexpr double most_bent_in_chart = 2e-4;
/// Curves that are bent more are compared with parabolas before they are taken for such.
constexpr double hardly_bent = 1e-2;
constexpr double most_pieces = 10000;
/// Ground of which no more than this share lacks normals has them all: it is what rounding and the
/// scales of pixels leave.
constexpr double complete_share = 1e-5;

/// How far the middle of a curve lies from its chord, in the area of a parabola through it: above 0
/// where the curve lies to the right of the way in a picture whose rows go down.
double area_beside(Point start, Point middle, Point end) {
  const double twice =
      (middle.x - start.x) * (end.y - start.y) - (end.x - start.x) * (middle.y - start.y);
  return -2.0 / 3 * twice;
}

/// The parabola through three points of a curve, of which the second lies halfway along it.
struct Parabola {
  Point start;
  Point middle;
  Point end;

  Point at(double along) const {
    const Point on_chord = between(start, end, along);
    const Point half = between(start, end, 0.5);
    const double share = 4 * along * (1 - along);
    return {on_chord.x + share * (middle.x - half.x), on_chord.y + share * (middle.y - half.y)};
  }
  double sagitta() const {
    const Point half = between(start, end, 0.5);
    return std::hypot(middle.x - half.x, middle.y - half.y);
  }
};

/// Follows edges into the pixels of a window. `ToStudy` takes their points to the study's
/// coordinates.
template <typename ToStudy>
class WindowMeasure : public GroundMeasure {
 public:
  /// `bent` is how far a piece of an edge may lie from its chord; 0 where all edges are straight.
  WindowMeasure(const NormalWindow& window, ToStudy to_study, double bent)
      : window_(window), to_study_(std::move(to_study)), bent_(bent) {}

  std::size_t figures() const override { return window_.pixels.figures(); }

  void add(Point from, Point to, double bulge, std::span<double> figures) const override {
    std::array<double, most_figures> sums{};
    const std::span<double> here = std::span(sums).first(figures.size());
    const bool is_back = to < from;
    if (is_back) {
      add_there(to, from, -bulge, here);
    } else {
      add_there(from, to, bulge, here);
    }
    for (std::size_t f = 0; f < figures.size(); ++f) figures[f] += is_back ? -here[f] : here[f];
  }

 private:
  static constexpr std::size_t most_figures = 32;

  Point pixel(Point p) const { return window_.mapping->to_pixels(to_study_(p)); }
  /// The pixel of an edge's end, which one edge in two shares with the edge before.
  Point pixel_of_end(Point p) const {
    if constexpr (ToStudy::is_of_one_thread) {
      for (const Known& known : known_) {
        if (known.end == p) return known.pixel;
      }
      const Known& found = known_[oldest_] = {p, pixel(p)};
      oldest_ = 1 - oldest_;
      return found.pixel;
    }
    return pixel(p);
  }

  void add_there(Point from, Point to, double bulge, std::span<double> figures) const {
    Parabola curve{pixel_of_end(from), {}, pixel_of_end(to)};
    if (bent_ == 0) {
      curve.middle = between(curve.start, curve.end, 0.5);
      window_.pixels.add_edge(curve.start, curve.end, figures);
    } else {
      curve.middle = pixel(between(from, to, 0.5));
      add_curve(from, to, curve, figures);
    }
    if (!window_.keeps_turns) {
      for (double& figure : figures) figure = -figure;
    }
    if (bulge != 0) add_bulge(curve, bulge, figures);
  }

  void add_curve(Point from, Point to, const Parabola& curve, std::span<double> figures) const {
    const double sagitta = curve.sagitta();
    if (sagitta > hardly_bent && is_no_parabola(from, to, curve)) {
      const Point half = between(from, to, 0.5);
      const Point first = pixel(between(from, half, 0.5));
      const Point second = pixel(between(half, to, 0.5));
      add_curve(from, half, {curve.start, first, curve.middle}, figures);
      add_curve(half, to, {curve.middle, second, curve.end}, figures);
      return;
    }
    const PixelIntegrals& pixels = window_.pixels;
    const double pieces = std::clamp(std::ceil(std::sqrt(sagitta / bent_)), 1.0, most_pieces);
    Point before = curve.start;
    for (double piece = 0; piece < pieces; ++piece) {
      const Point middle = curve.at((piece + 0.5) / pieces);
      const Point after = piece + 1 == pieces ? curve.end : curve.at((piece + 1) / pieces);
      pixels.add_edge(before, after, figures);
      pixels.add_at(middle, area_beside(before, middle, after) * pixels.pixel_area(middle),
                    figures);
      before = after;
    }
  }

  bool is_no_parabola(Point from, Point to, const Parabola& curve) const {
    const Point there = pixel(between(from, to, 0.25));
    const Point taken = curve.at(0.25);
    return std::hypot(there.x - taken.x, there.y - taken.y) > bent_ &&
           std::hypot(to.x - from.x, to.y - from.y) > 1e-9;
  }

  void add_bulge(const Parabola& curve, double bulge, std::span<double> figures) const {
    constexpr int parts = 5;
    for (int part = 0; part < parts; ++part) {
      const double share =
          bulge_share((part + 1.0) / parts) - bulge_share(static_cast<double>(part) / parts);
      window_.pixels.add_at(curve.at((part + 0.5) / parts), bulge * share, figures);
    }
  }

  const NormalWindow& window_;
  ToStudy to_study_;
  double bent_;
  /// Ends of edges that came last.
  struct Known {
    Point end{std::numeric_limits<double>::quiet_NaN(), 0};
    Point pixel;
  };
  mutable std::array<Known, 2> known_;
  mutable std::size_t oldest_ = 0;
};

struct InStudy {
  static constexpr bool is_of_one_thread = false;
  Point operator()(Point p) const { return p; }
};

/// From a chart to longitude and latitude, which run on where the basin's do.
struct FromChart {
  static constexpr bool is_of_one_thread = true;
  GnomonicChart chart;
  double near_longitude;
  Point operator()(Point p) const {
    Point there = from_sphere(chart.direction(p));
    there.x += 360 * std::round((near_longitude - there.x) / 360);
    return there;
  }
};

}  // namespace

RasterBasinNormals::RasterBasinNormals(NormalWindow window, const Basin& basin, double area)
    : window_(std::move(window)),
      measure_(std::make_unique<const WindowMeasure<InStudy>>(
          window_, InStudy(), window_.mapping->keeps_straight() ? 0 : most_bent)) {
  std::vector<double> figures(measure_->figures(), 0);
  std::size_t ring_number = 0;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double bulge = basin.bulges.empty() ? 0 : basin.bulges[ring_number][i];
      measure_->add(ring[i], ring[(i + 1) % ring.size()], bulge, figures);
    }
    ++ring_number;
  };
  for (const Polygon& part : basin.shape) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  for (std::size_t m = 0; m < window_.pixels.bands(); ++m) whole_.push_back(of(figures, area, m));
}

std::unique_ptr<const GroundMeasure> RasterBasinNormals::measure_in(
    const GnomonicChart& chart) const {
  return std::make_unique<const WindowMeasure<FromChart>>(
      window_, FromChart{chart, window_.middle_longitude}, most_bent_in_chart);
}

GroundNormal RasterBasinNormals::of(std::span<const double> figures, double area,
                                    std::size_t month) const {
  const PixelIntegrals& pixels = window_.pixels;
  const double covered = figures[PixelIntegrals::covered_of(month)];
  const double whole = window_.holds_all ? figures[0] : area;
  const double share = std::clamp(covered / whole, 0.0, 1.0);
  if (!(share > complete_share)) return {std::numeric_limits<double>::quiet_NaN(), 0};
  const double excess = figures[PixelIntegrals::excess_of(month)] / covered;
  return {pixels.reference(month) + excess, share > 1 - complete_share ? 1 : share};
}

double RasterBasinNormals::at(Point p, std::size_t month) const {
  return window_.pixels.value_at(window_.mapping->to_pixels(p), month);
}

RasterNormals::RasterNormals(std::vector<std::vector<double>> gauges,
                             std::vector<NormalWindow> windows, const std::vector<Basin>& basins,
                             const std::vector<double>& areas)
    : gauges_(std::move(gauges)) {
  basins_.reserve(windows.size());
  for (std::size_t b = 0; b < windows.size(); ++b) {
    basins_.push_back(
        std::make_unique<const RasterBasinNormals>(std::move(windows[b]), basins[b], areas[b]));
  }
}

}  // namespace thiessen
