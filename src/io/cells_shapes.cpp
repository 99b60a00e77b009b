#include "io/cells_shapes.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "geometry/ring_location.h"
#include "io/antimeridian.h"
#include "io/edge_tracing.h"
#include "io/ring_direction.h"

namespace thiessen {
namespace {

bool in_degrees(const Crs& crs) {
  return crs.geographic() && crs.degrees_per_unit() == 1;
}

MultiPolygon traced(const CellFeature& cell, EdgeTracer& tracer, const Crs& target) {
  MultiPolygon shape = cell.shape;
  const auto ring = [&](Ring& points) {
    auto seen = tracer.trace(points);
    if (!seen) {
      throw Error(Message{{},
                          0,
                          "the cell of station " + quoted(cell.station, 80) +
                              " reaches outside the area of " + target.name(),
                          "cells in longitude and latitude (.geojson) reach anywhere"});
    }
    points = std::move(seen->ring);
  };
  for (Polygon& polygon : shape) {
    ring(polygon.outer);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), ring);
  }
  turn_rings(shape);
  return shape;
}

/// Where the plane has the poles, as far as its projection reaches them.
std::vector<Point> poles_in(const Crs& plane) {
  const Transformation to_plane(Crs::wgs84(), plane);
  std::vector<Point> poles;
  for (const double latitude : {-90.0, 90.0}) {
    if (const auto pole = to_plane({0, latitude})) poles.push_back(*pole);
  }
  return poles;
}

// A ring round a pole, or through it, is no ring in longitude and latitude.
void refuse_poles(const CellFeature& cell, const std::vector<Point>& poles) {
  for (const Polygon& part : cell.shape) {
    for (const Point pole : poles) {
      if (locate(part.outer, pole) == Where::outside) continue;
      throw Error(
          Message{{},
                  0,
                  "the cell of station " + quoted(cell.station, 80) +
                      " reaches to a pole: in longitude and latitude it cannot be written yet",
                  "a format with the plane's own CRS, such as .gpkg, holds it"});
    }
  }
}

}  // namespace

std::vector<MultiPolygon> cells_shapes(const CellsOutput& output,
                                       const std::optional<Crs>& target) {
  std::vector<MultiPolygon> shapes;
  shapes.reserve(output.cells.size());
  std::optional<EdgeTracer> tracer;
  if (target && output.study_crs && !target->same_as(*output.study_crs)) {
    tracer.emplace(*output.study_crs, *target, output.tolerance / 2, false);
  }
  const bool cut = target && in_degrees(*target);
  std::vector<Point> poles;
  if (cut && tracer && !output.study_crs->geographic()) poles = poles_in(*output.study_crs);
  for (const CellFeature& cell : output.cells) {
    refuse_poles(cell, poles);
    MultiPolygon shape = tracer ? traced(cell, *tracer, *target) : cell.shape;
    shapes.push_back(cut ? cut_at_antimeridian(shape) : std::move(shape));
  }
  return shapes;
}

}  // namespace thiessen
