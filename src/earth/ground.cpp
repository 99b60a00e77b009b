#include "earth/ground.h"

#include "earth/sphere_diagram.h"
#include "tessellation/plane_diagram.h"

namespace thiessen {
namespace {

// The rest of the tolerance is for rounding to decimals when the cells are written.
constexpr double share_for_chords = 0.5;

}  // namespace

Diagram Ground::diagram(std::span<const Point> places, const Box& frame) const {
  if (metric == Metric::planar) return plane_diagram(places, frame);
  return sphere_diagram(places, frame, share_for_chords * tolerance);
}

std::unique_ptr<Surface> Ground::surface() const {
  if (metric == Metric::planar) return std::make_unique<PlaneSurface>(unit_area);
  return std::make_unique<EllipsoidSurface>();
}

}  // namespace thiessen
