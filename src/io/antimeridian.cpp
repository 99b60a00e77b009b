#include "io/antimeridian.h"

#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "io/gdal_errors.h"
#include "io/geometry_conversion.h"
#include "io/ring_direction.h"

namespace thiessen {
namespace {

/// Where the edge crosses the meridian: the same from either end.
Point crossing(Point a, Point b, double meridian) {
  if (b < a) std::swap(a, b);
  return {meridian, a.y + (meridian - a.x) * ((b.y - a.y) / (b.x - a.x))};
}

/// The ring with a vertex wherever it crosses the antimeridian.
Ring noded(const Ring& ring) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    result.push_back(a);
    const double low = std::min(a.x, b.x);
    const double high = std::max(a.x, b.x);
    Ring met;
    for (double turn = std::ceil((low - 180) / 360); 180 + 360 * turn <= high; ++turn) {
      const double meridian = 180 + 360 * turn;
      if (low < meridian && meridian < high) met.push_back(crossing(a, b, meridian));
    }
    if (b.x < a.x) std::reverse(met.begin(), met.end());
    result.insert(result.end(), met.begin(), met.end());
  }
  return result;
}

std::unique_ptr<OGRPolygon> strip(double west) {
  const MultiPolygon box = {{{{west, -91}, {west + 360, -91}, {west + 360, 91}, {west, 91}}, {}}};
  return std::unique_ptr<OGRPolygon>(ogr_shape(box)->getGeometryRef(0)->clone());
}

void shift(Ring& ring, double degrees) {
  for (Point& point : ring) point.x += degrees;
}

void cut(const Polygon& polygon, double west, double east, MultiPolygon& into) {
  Polygon with_nodes{noded(polygon.outer), {}};
  for (const Ring& hole : polygon.holes) with_nodes.holes.push_back(noded(hole));
  const auto whole = ogr_shape({with_nodes});
  const GdalErrors errors;
  for (double turn = std::floor((west + 180) / 360); - 180 + 360 * turn < east; ++turn) {
    const std::unique_ptr<OGRGeometry> part(whole->Intersection(strip(-180 + 360 * turn).get()));
    if (!part) continue;
    for (Polygon& piece : polygons_of(*part)) {
      shift(piece.outer, -360 * turn);
      for (Ring& hole : piece.holes) shift(hole, -360 * turn);
      into.push_back(std::move(piece));
    }
  }
}

}  // namespace

MultiPolygon cut_at_antimeridian(const MultiPolygon& shape) {
  MultiPolygon result;
  for (const Polygon& polygon : shape) {
    const auto [west, east] = std::minmax_element(polygon.outer.begin(), polygon.outer.end());
    if (polygon.outer.empty() || (west->x >= -180 && east->x <= 180)) {
      result.push_back(polygon);
    } else {
      cut(polygon, west->x, east->x, result);
    }
  }
  turn_rings(result);
  return result;
}

}  // namespace thiessen
