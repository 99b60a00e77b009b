#include "gdal/crs/shape_tracer.h"

#include <memory>
#include <utility>

#include "gdal/crs/transformation.h"

namespace thiessen {

ShapeTracer tracer_between(const Crs& from, const Crs& to, double chord_error, Course course) {
  auto mapping = std::make_shared<const Transformation>(from, to);
  PlanePoles poles;
  if (to.kind().in_degrees() && !from.geographic())
    poles = PlanePoles(Transformation(Crs::wgs84(), from));
  return {std::move(mapping), std::move(poles), chord_error, course};
}

}  // namespace thiessen
