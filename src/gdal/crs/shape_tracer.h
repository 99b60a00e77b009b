#pragma once

#include "gdal/crs/crs.h"
#include "outlines/shape_tracing.h"

namespace thiessen {

/// Makes the ShapeTracer that maps shapes whose edges are straight in one CRS to another. Throws
/// Error where no transformation of datum is known, naming both CRSs.
ShapeTracer tracer_between(const Crs& from, const Crs& to, double chord_error, Course course);

}  // namespace thiessen
