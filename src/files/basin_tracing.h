#pragma once

#include <optional>
#include <string>

#include "gdal/crs/crs.h"
#include "gdal/crs/shape_tracer.h"
#include "geometry/polygon.h"

namespace thiessen {

/// Takes basins whose edges are straight in one CRS to longitude and latitude on WGS 84.
class BasinTracing {
 public:
  /// A chord lies within a quarter of the tolerance (metres) of the true edge. Throws Error where
  /// no transformation of datum is known.
  BasinTracing(const Crs& from, const Crs& to, double tolerance);

  /// Traces a valid basin as ShapeTracer does, into a valid shape. Where rounding would make it
  /// cross itself, needles narrower than 1e-7 metres (to a millimetre where that is not enough) are
  /// collapsed in `basin` (but never all of it); where chords would, they are drawn finer. Neither
  /// shows in areas. The result is empty where the basin reaches outside the projection's area, at
  /// outside(), and where it crosses itself even so, for which fault() gives the reason. Cost: as
  /// ShapeTracer, and a check of validity.
  std::optional<CurvedShape> trace(MultiPolygon& basin);

  /// The width in metres of the needles that the last basin lost; 0 where it lost none.
  double collapsed() const { return collapsed_; }
  Point outside() const { return outside_; }
  const std::string& fault() const { return fault_; }

 private:
  std::optional<CurvedShape> trace_with(ShapeTracer& tracer, const MultiPolygon& basin);

  Crs from_;
  Crs to_;
  double tolerance_;
  ShapeTracer tracer_;
  Point outside_;
  std::string fault_;
  double collapsed_ = 0;
};

/// What became of a shape whose vertices were taken to a plane.
struct PlaneMending {
  bool redrawn = false;
  std::string fault;  ///< why the shape is not valid; empty where it is
};

/// Draws the rings of a basin anew that crosses itself once its vertices are taken to a plane,
/// where no more than 1e-5 of its area is in dispute (see ground_of). Cost: a check of validity.
PlaneMending make_valid_in_plane(MultiPolygon& shape);

}  // namespace thiessen
