#include "files/shape_target.h"

#include <utility>

#include "base/error.h"
#include "gdal/crs/shape_tracer.h"
#include "outlines/antimeridian.h"

namespace thiessen {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& what, const Crs& from,
                         const Crs& target) {
  // Degrees reach anywhere on the Earth: then it is the study's plane that the shape leaves.
  const bool leaves_plane = target.geographic();
  throw Error(
      Message{{},
              0,
              name + " reaches outside the area of " + (leaves_plane ? from : target).name(),
              leaves_plane ? "" : what + " in longitude and latitude (.geojson) reach anywhere"});
}

MultiPolygon cut(const MultiPolygon& whole) {
  CurvedShape shape{whole, {}};
  cut_at_antimeridian(shape);
  return std::move(shape.shape);
}

}  // namespace

ShapeTarget::ShapeTarget(std::optional<Crs> study, std::optional<Crs> target, double tolerance)
    : study_(std::move(study)), target_(std::move(target)) {
  if (target_ && study_ && !target_->same_as(*study_))
    tracer_ = tracer_between(*study_, *target_, tolerance / 2, Course::chords);
}

MultiPolygon ShapeTarget::of(const MultiPolygon& shape, const std::string& name,
                             const std::string& what) {
  if (tracer_) {
    auto seen = tracer_->trace(shape, Longitudes::cut);
    if (!seen) refuse(name, what, *study_, *target_);
    return std::move(seen->shape);
  }
  return target_ && target_->kind().in_degrees() ? cut(shape) : shape;
}

}  // namespace thiessen
