#pragma once

#include <geos_c.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen::geos {

/// A GEOS geometry of its own, with a context of its own: the judge of areas and of validity.
class Context {
 public:
  Context() : handle_(GEOS_init_r()) {}
  ~Context() { GEOS_finish_r(handle_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  GEOSContextHandle_t get() const { return handle_; }

 private:
  GEOSContextHandle_t handle_;
};

inline GEOSContextHandle_t context() {
  thread_local const Context context;
  return context.get();
}

struct Destroy {
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(context(), g); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

inline GEOSGeometry* ring_of(const Ring& ring) {
  const auto size = static_cast<unsigned>(ring.size() + 1);
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(context(), size, 2);
  for (unsigned i = 0; i < size; ++i) {
    const Point p = ring[i % ring.size()];
    GEOSCoordSeq_setXY_r(context(), sequence, i, p.x, p.y);
  }
  return GEOSGeom_createLinearRing_r(context(), sequence);
}

inline GEOSGeometry* polygon_of(const Polygon& polygon) {
  std::vector<GEOSGeometry*> holes;
  for (const Ring& hole : polygon.holes) holes.push_back(ring_of(hole));
  return GEOSGeom_createPolygon_r(context(), ring_of(polygon.outer), holes.data(),
                                  static_cast<unsigned>(holes.size()));
}

inline Geometry geometry_of(const MultiPolygon& shape) {
  std::vector<GEOSGeometry*> parts;
  for (const Polygon& part : shape) parts.push_back(polygon_of(part));
  return Geometry(GEOSGeom_createCollection_r(context(), GEOS_MULTIPOLYGON, parts.data(),
                                              static_cast<unsigned>(parts.size())));
}

inline double area(const GEOSGeometry& g) {
  double area = 0;
  if (GEOSArea_r(context(), &g, &area) != 1) throw std::runtime_error("GEOS finds no area");
  return area;
}

inline Geometry intersection(const GEOSGeometry& a, const GEOSGeometry& b) {
  Geometry result(GEOSIntersection_r(context(), &a, &b));
  if (!result) throw std::runtime_error("GEOS cannot intersect");
  return result;
}

/// Empty where the shape is valid.
inline std::string reason_invalid(const GEOSGeometry& g) {
  if (GEOSisValid_r(context(), &g) == 1) return {};
  char* text = GEOSisValidReason_r(context(), &g);
  std::string reason = text == nullptr ? "unknown" : text;
  GEOSFree_r(context(), text);
  return reason;
}

/// The same points as a valid geometry.
inline Geometry made_valid(const GEOSGeometry& g) {
  Geometry result(GEOSMakeValid_r(context(), &g));
  if (!result) throw std::runtime_error("GEOS cannot make a geometry valid");
  return result;
}

}  // namespace thiessen::geos
