#include "files/cells_shapes.h"

#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "gdal/crs/shape_tracer.h"
#include "outlines/antimeridian.h"

namespace thiessen {
namespace {

MultiPolygon traced(const CellFeature& cell, ShapeTracer& tracer, const Crs& target) {
  auto seen = tracer.trace(cell.shape, Longitudes::cut);
  if (!seen) {
    throw Error(Message{{},
                        0,
                        "the cell of station " + quoted(cell.station, 80) +
                            " reaches outside the area of " + target.name(),
                        "cells in longitude and latitude (.geojson) reach anywhere"});
  }
  return std::move(seen->shape);
}

MultiPolygon cut(const CellFeature& cell) {
  CurvedShape shape{cell.shape, {}};
  cut_at_antimeridian(shape);
  return std::move(shape.shape);
}

}  // namespace

std::vector<MultiPolygon> cells_shapes(const CellsOutput& output,
                                       const std::optional<Crs>& target) {
  std::vector<MultiPolygon> shapes;
  shapes.reserve(output.cells.size());
  std::optional<ShapeTracer> tracer;
  if (target && output.study_crs && !target->same_as(*output.study_crs))
    tracer = tracer_between(*output.study_crs, *target, output.tolerance / 2, Course::chords);
  for (const CellFeature& cell : output.cells) {
    if (tracer) {
      shapes.push_back(traced(cell, *tracer, *target));
    } else {
      shapes.push_back(target && target->kind().in_degrees() ? cut(cell) : cell.shape);
    }
  }
  return shapes;
}

}  // namespace thiessen
