#include "io/cells_shapes.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
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
  for (const CellFeature& cell : output.cells) {
    MultiPolygon shape = tracer ? traced(cell, *tracer, *target) : cell.shape;
    shapes.push_back(cut ? cut_at_antimeridian(shape) : std::move(shape));
  }
  return shapes;
}

}  // namespace thiessen
