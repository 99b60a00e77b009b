#include "outlines/polygon_validity.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

#include "outlines/geos.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

/// A valid shape by one of GEOS's two methods: `linework` is the even-odd rule for a single ring;
/// `structure` is the union of the shells minus the union of the holes.
MultiPolygon made_valid(const MultiPolygon& shape, GEOSMakeValidMethods method) {
  const Geos geos;
  const Geos::Shape geometry = geos.shape_of(shape);
  if (!geometry) return {};
  const auto destroy = [&](GEOSMakeValidParams* params) {
    GEOSMakeValidParams_destroy_r(geos.context(), params);
  };
  const std::unique_ptr<GEOSMakeValidParams, decltype(destroy)> way(
      GEOSMakeValidParams_create_r(geos.context()), destroy);
  if (!way) throw std::bad_alloc();
  GEOSMakeValidParams_setMethod_r(geos.context(), way.get(), method);
  GEOSMakeValidParams_setKeepCollapsed_r(geos.context(), way.get(), 0);
  const Geos::Shape valid =
      geos.own(GEOSMakeValidWithParams_r(geos.context(), geometry.get(), way.get()));
  return geos.polygons_of(valid.get());
}

/// The area by which rings together cover more or less than their union.
double overlap(const MultiPolygon& rings) {
  if (rings.size() < 2 || validity_fault(rings).empty()) return 0;
  return std::abs(plane_area(made_valid(rings)) - plane_area(rings));
}

/// The area that a ring goes round some other number of times than once.
double disputed_area(const Polygon& ring) {
  const MultiPolygon one = {ring};
  if (validity_fault(one).empty()) return 0;
  const double area = plane_area(one);
  return std::max(std::abs(plane_area(made_valid(one, GEOS_MAKE_VALID_LINEWORK)) - area),
                  std::abs(plane_area(made_valid(one)) - area));
}

}  // namespace

double plane_area(const MultiPolygon& shape) {
  double sum = 0;
  for (const Polygon& polygon : shape) {
    sum += std::abs(signed_area(polygon.outer));
    for (const Ring& hole : polygon.holes) sum -= std::abs(signed_area(hole));
  }
  return sum;
}

std::string validity_fault(const MultiPolygon& shape) {
  const Geos geos;
  const Geos::Shape geometry = geos.shape_of(shape);
  constexpr char valid = 1;
  if (geometry && GEOSisValid_r(geos.context(), geometry.get()) == valid) return {};
  std::string reason = geos.text().empty() ? "GEOS gives no reason" : geos.text();
  for (char& c : reason) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return reason;
}

MultiPolygon made_valid(const MultiPolygon& shape) {
  return made_valid(shape, GEOS_MAKE_VALID_STRUCTURE);
}

double disputed_area(const MultiPolygon& shape, const MultiPolygon& valid) {
  MultiPolygon shells;
  MultiPolygon holes;
  double rings = 0;
  for (const Polygon& polygon : shape) {
    shells.push_back({polygon.outer, {}});
    rings += disputed_area(shells.back());
    for (const Ring& hole : polygon.holes) {
      holes.push_back({hole, {}});
      rings += disputed_area(holes.back());
    }
  }
  const double whole = std::abs(plane_area(valid) - plane_area(shape));
  return std::max({whole, rings, overlap(shells), overlap(holes)});
}

}  // namespace thiessen
