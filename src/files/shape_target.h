#pragma once

#include <optional>
#include <string>

#include "gdal/crs/crs.h"
#include "geometry/polygon.h"
#include "outlines/shape_tracing.h"

namespace thiessen {

/// Takes shapes of a study into the CRS in which they are written. Edges are straight in the
/// study's coordinates: in another CRS they are subdivided until they lie within half the
/// tolerance, at the same points for both neighbours. Longitudes are cut at the antimeridian.
/// Without a CRS shapes stay as they are.
class ShapeTarget {
 public:
  /// `study` is the CRS of the shapes, nothing for a plane without one. Throws Error where no
  /// transformation of datum is known.
  ShapeTarget(std::optional<Crs> study, std::optional<Crs> target, double tolerance);

  /// The shape in the target's coordinates. Throws Error where it reaches outside the area of the
  /// target, or of the study's CRS. `name` is its name in messages, such as "the cell of station
  /// 'a'", and `what` the word for several: "cells".
  MultiPolygon of(const MultiPolygon& shape, const std::string& name, const std::string& what);

 private:
  std::optional<Crs> study_;
  std::optional<Crs> target_;
  std::optional<ShapeTracer> tracer_;
};

}  // namespace thiessen
