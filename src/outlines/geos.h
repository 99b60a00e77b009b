#pragma once

#include <geos_c.h>

#include <memory>
#include <string>

#include "geometry/polygon.h"

namespace thiessen {

/// GEOS for one task, on one thread: it keeps what GEOS says to itself, so that nothing is printed.
class Geos {
 public:
  struct Destroy {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
  };
  using Shape = std::unique_ptr<GEOSGeometry, Destroy>;

  Geos();
  ~Geos();
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  GEOSContextHandle_t context() const { return context_; }
  /// What GEOS said first: why a shape is not valid, or why it cannot answer.
  const std::string& text() const { return text_; }
  Shape own(GEOSGeometry* geometry) const { return {geometry, Destroy{context_}}; }
  /// Null where a ring has one point or two; text() then says so.
  Shape shape_of(const MultiPolygon& polygons) const;
  /// Every polygon within a shape, rings without the repeated last point; none of null.
  MultiPolygon polygons_of(const GEOSGeometry* shape) const;

 private:
  GEOSGeometry* ring_of(const Ring& ring) const;
  GEOSGeometry* polygon_of(const Polygon& polygon) const;
  Ring points_of(const GEOSGeometry* ring) const;
  void gather(const GEOSGeometry* shape, MultiPolygon& into) const;
  static void hear(const char* message, void* self);

  GEOSContextHandle_t context_;
  std::string text_;
};

}  // namespace thiessen
