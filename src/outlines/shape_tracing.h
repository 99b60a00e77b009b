#pragma once

#include <memory>
#include <optional>
#include <set>

#include "outlines/antimeridian.h"
#include "outlines/edge_tracing.h"
#include "outlines/mapping.h"
#include "outlines/winding_polygon.h"

namespace thiessen {

/// Maps shapes whose edges are straight in one system of coordinates to another, wherever on the
/// Earth they lie.
class ShapeTracer {
 public:
  /// The parameters after `mapping` are those of EdgeTracer.
  ShapeTracer(std::shared_ptr<const Mapping> mapping, PlanePoles poles, double chord_error,
              Course course);

  /// Traces a shape; the result's outer rings run counter-clockwise. In degrees, polygons that hold
  /// a pole, and with Longitudes::cut all that cross the antimeridian, are cut there. From degrees,
  /// shapes that are cut there are joined again, unless the projection itself is cut there. The
  /// result is empty where the shape reaches outside the projection's area; `outside()` is then
  /// where, in `from`. Requires a valid shape with outer rings counter-clockwise. Cost: as
  /// EdgeTracer.
  std::optional<CurvedShape> trace(const MultiPolygon& shape, Longitudes longitudes);
  /// Traces a shape to which cutting gave vertices on the antimeridian. Where it is joined again,
  /// those at latitudes other than `own` are left out.
  std::optional<CurvedShape> trace_without_cuts(const MultiPolygon& shape,
                                                const std::set<double>& own);
  /// The point, in `from`, at which the last shape reached outside the projection's area.
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
  double metres_per_unit_;  ///< of the system to which shapes are mapped
  Point outside_;
};

}  // namespace thiessen
