#include "map/raster/raster_grid.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

constexpr double default_pixels = 2000;
constexpr double largest_side = 100'000;
constexpr double most_pixels = 400e6;

Ring mapped(const Ring& ring, const PointMapping& mapping) {
  constexpr int steps = 1000;
  Ring fine;
  fine.reserve(ring.size() * steps);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    for (int s = 0; s < steps; ++s) {
      const double share = static_cast<double>(s) / steps;
      fine.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    }
  }
  mapping(fine);
  std::erase_if(fine, [](Point p) { return !std::isfinite(p.x) || !std::isfinite(p.y); });
  return fine;
}

// A value within a few roundings of a multiple counts as the multiple, as value, step and their
// quotient are each rounded by at most 2^-53 of themselves.
double snapped(double value, double step, double (*towards)(double)) {
  constexpr double rounding = 0x1p-51;
  const double steps = value / step;
  const double nearest = std::round(steps);
  const bool is_multiple = std::abs(steps - nearest) <= rounding * std::abs(nearest);
  return (is_multiple ? nearest : towards(steps)) * step;
}

}  // namespace

MultiPolygon mapped_extent(const MultiPolygon& extent, const PointMapping& to_raster) {
  MultiPolygon there;
  for (const Polygon& part : extent) {
    Polygon& mapped_part = there.emplace_back();
    mapped_part.outer = mapped(part.outer, to_raster);
    for (const Ring& hole : part.holes) mapped_part.holes.push_back(mapped(hole, to_raster));
  }
  return there;
}

PixelGrid grid_over(const std::vector<MultiPolygon>& areas, double resolution) {
  Box box;
  for (const MultiPolygon& area : areas) {
    for (const Polygon& part : area) box.take_in(box_of(part.outer));
  }
  if (!(std::max(box.width(), box.height()) > 0)) {
    throw Error({"", 0, "the study area has no extent in the raster's coordinates", ""});
  }
  PixelGrid grid;
  grid.pixel = resolution > 0 ? resolution : std::max(box.width(), box.height()) / default_pixels;
  const double west = snapped(box.low.x, grid.pixel, std::floor);
  const double north = snapped(box.high.y, grid.pixel, std::ceil);
  const double columns =
      std::max(1.0, std::round((snapped(box.high.x, grid.pixel, std::ceil) - west) / grid.pixel));
  const double rows =
      std::max(1.0, std::round((north - snapped(box.low.y, grid.pixel, std::floor)) / grid.pixel));
  if (!(columns <= largest_side && rows <= largest_side && columns * rows <= most_pixels)) {
    throw Error({"", 0,
                 "the raster would have " + fixed_text(columns, 0) + " x " + fixed_text(rows, 0) +
                     " pixels; the most are 400 million, and 100000 on a side",
                 "a larger " + setting("resolution") + " makes it smaller"});
  }
  grid.north_west = {west, north};
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  return grid;
}

}  // namespace thiessen
