#include "study/gauge_spacing.h"

#include <algorithm>
#include <limits>

#include "earth/sphere/conformal_sphere.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

constexpr double far_beside_others = 5;

/// The places in a chart in which their Delaunay tessellation is that of the Earth.
std::vector<Point> in_chart(std::span<const Point> places, const Ruler& ruler) {
  if (!ruler.on_earth()) return {places.begin(), places.end()};
  std::vector<Direction> directions;
  Direction middle;
  for (const Point p : places) {
    directions.push_back(unit(ruler.in_space(p)));
    middle = middle + directions.back();
  }
  // Places all round the Earth have no middle; then any pole will do.
  const bool has_middle = length(middle) > 1e-6 * static_cast<double>(places.size());
  const StereographicChart chart(has_middle ? -1 * unit(middle) : Direction{0, 0, -1});
  std::vector<Point> charted;
  charted.reserve(directions.size());
  for (const Direction d : directions)
    charted.push_back(chart.is_pole(d) ? Point{1e9, 0} : chart.project(d));
  return charted;
}

}  // namespace

GaugeSpacing spacing_of(std::span<const Point> places, const Ruler& ruler) {
  GaugeSpacing spacing;
  spacing.to_nearest.assign(places.size(), std::numeric_limits<double>::infinity());
  Tessellation<2> tessellation;
  const std::vector<PointId> point_of = tessellation.add_all(in_chart(places, ruler));
  std::vector<std::size_t> place_of(tessellation.topology().point_limit());
  for (std::size_t i = point_of.size(); i-- > 0;) place_of[index(point_of[i])] = i;
  std::vector<double> edges;
  tessellation.for_each_point([&](PointId p) {
    const std::size_t a = place_of[index(p)];
    tessellation.for_each_neighbour(p, [&](PointId q) {
      const std::size_t b = place_of[index(q)];
      if (b < a) return;
      const double length = ruler.distance(places[a], places[b]);
      edges.push_back(length);
      for (const std::size_t end : {a, b})
        spacing.to_nearest[end] = std::min(spacing.to_nearest[end], length);
    });
  });
  // Rounding may put places into one point of the chart.
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t twin = place_of[index(point_of[i])];
    if (twin == i) continue;
    spacing.to_nearest[i] = ruler.distance(places[i], places[twin]);
    spacing.to_nearest[twin] = std::min(spacing.to_nearest[twin], spacing.to_nearest[i]);
  }
  if (edges.empty()) return spacing;
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  spacing.median_edge = *middle;
  return spacing;
}

std::vector<LonelyPlace> lonely_places(const GaugeSpacing& spacing) {
  std::vector<LonelyPlace> lonely;
  const std::size_t count = spacing.to_nearest.size();
  if (count < 3) return lonely;
  std::vector<double> sorted = spacing.to_nearest;
  std::sort(sorted.begin(), sorted.end());
  const double limit = far_beside_others * sorted[(count - 1) * 4 / 5];
  for (std::uint32_t p = 0; p < count; ++p) {
    if (spacing.to_nearest[p] > limit) lonely.push_back({PlaceIndex{p}, spacing.to_nearest[p]});
  }
  return lonely;
}

}  // namespace thiessen
