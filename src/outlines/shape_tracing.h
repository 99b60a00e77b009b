#pragma once

#include <memory>
#include <optional>
#include <set>

#include "outlines/antimeridian.h"
#include "outlines/edge_tracing.h"
#include "outlines/mapping.h"
#include "outlines/winding_polygon.h"

namespace thiessen {

/// Takes shapes whose edges are straight in one system of coordinates to another, wherever on the
/// Earth they are.
class ShapeTracer {
 public:
  /// As EdgeTracer.
  ShapeTracer(std::shared_ptr<const Mapping> mapping, PlanePoles poles, double chord_error,
              Course course);

  /// The shape with outer rings counter-clockwise. In degrees, polygons that hold a pole, and with
  /// Longitudes::cut all that cross the antimeridian, are cut there; from degrees, what is cut
  /// there is joined again, unless the projection itself is cut there. Nothing where the shape
  /// reaches outside the projection's area: then `outside()` is where, in `from`. Requires a valid
  /// shape with outer rings counter-clockwise. Cost: as EdgeTracer.
  std::optional<CurvedShape> trace(const MultiPolygon& shape, Longitudes longitudes);
  /// The same of a shape that cutting gave vertices on the antimeridian: those at other latitudes
  /// than `own` are left out where it is joined again.
  std::optional<CurvedShape> trace_without_cuts(const MultiPolygon& shape,
                                                const std::set<double>& own);
  Point outside() const { return outside_; }

 private:
  std::optional<CurvedShape> to_degrees(const MultiPolygon& shape, Longitudes longitudes);
  bool reaches_poles(const MultiPolygon& shape);
  std::optional<CurvedShape> from_degrees(const MultiPolygon& shape, const std::set<double>* own);
  std::optional<CurvedShape> joined(const MultiPolygon& shape, const std::set<double>* own);
  std::set<Point> cuts_of(const std::vector<DirectedEdge>& edges,
                          const std::set<double>& own) const;
  std::optional<CurvedShape> ring_by_ring(const MultiPolygon& shape);

  std::shared_ptr<const Mapping> mapping_;
  EdgeTracer tracer_;
  bool from_degrees_;
  bool to_degrees_;
  double metres_per_unit_;  ///< of what shapes are taken to
  Point outside_;
};

}  // namespace thiessen
