#include "files/cells_shapes.h"

#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "gdal/crs/shape_tracer.h"
#include "outlines/antimeridian.h"

namespace thiessen {
namespace {

[[noreturn]] void refuse(const CellFeature& cell, const Crs& from, const Crs& target) {
  // Degrees reach anywhere on the Earth: then it is the study's plane that the cell leaves.
  const bool leaves_plane = target.geographic();
  throw Error(
      Message{{},
              0,
              "the cell of station " + quoted(cell.station, 80) + " reaches outside the area of " +
                  (leaves_plane ? from : target).name(),
              leaves_plane ? "" : "cells in longitude and latitude (.geojson) reach anywhere"});
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
      auto seen = tracer->trace(cell.shape, Longitudes::cut);
      if (!seen) refuse(cell, *output.study_crs, *target);
      shapes.push_back(std::move(seen->shape));
    } else {
      shapes.push_back(target && target->kind().in_degrees() ? cut(cell) : cell.shape);
    }
  }
  return shapes;
}

}  // namespace thiessen
