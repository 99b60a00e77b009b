#pragma once

#include <geos_c.h>

#include <memory>
#include <span>
#include <string>

#include "geometry/polygon.h"

namespace thiessen {

/// A GEOS context for one task on one thread. It keeps GEOS's messages, so that nothing is printed.
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
  /// The first message of GEOS: why a shape is not valid, or why GEOS cannot answer.
  const std::string& text() const { return text_; }
  Shape own(GEOSGeometry* geometry) const { return {geometry, Destroy{context_}}; }
  /// The shape as GEOS has it, rings closed. Null where GEOS cannot make it, as of a ring of one
  /// point; text() then says why. Requires finite coordinates.
  Shape shape_of(const MultiPolygon& polygons) const;
  /// Rings as closed lines, whatever they cross. Null where GEOS cannot make them. Requires finite
  /// coordinates.
  Shape lines_of(std::span<const Ring> rings) const;
  /// Every polygon within a GEOS geometry, with rings that do not repeat the last point; none where
  /// it is null.
  MultiPolygon polygons_of(const GEOSGeometry* shape) const;

 private:
  GEOSCoordSequence* closed_points(const Ring& ring) const;
  GEOSGeometry* ring_of(const Ring& ring) const;
  GEOSGeometry* polygon_of(const Polygon& polygon) const;
  Ring points_of(const GEOSGeometry* ring) const;
  void gather(const GEOSGeometry* shape, MultiPolygon& into) const;
  static void hear(const char* message, void* self) noexcept;

  GEOSContextHandle_t context_;
  std::string text_;
};

}  // namespace thiessen
