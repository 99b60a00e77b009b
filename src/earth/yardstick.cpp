#include "earth/yardstick.h"

#include <algorithm>

#include "diagram/plane_diagram.h"
#include "earth/area/ellipsoid_surface.h"
#include "earth/cells/geodesic_diagram.h"

namespace thiessen {
namespace {

// These are shares of the tolerance. The rest of it is for rounding to decimals when the cells are
// written.
constexpr double share_for_chords = 0.5;
constexpr double share_for_points = 1e-2;
constexpr double finest_accuracy = 1e-6;  // metres

}  // namespace

Diagram Yardstick::diagram(std::span<const Point> places, const Box& frame,
                           unsigned threads) const {
  if (metric == Metric::planar) return plane_diagram(places, frame);
  return geodesic_diagram(places, frame, share_for_chords * tolerance, finest_accuracy, threads);
}

Diagram Yardstick::diagram_for_areas(std::span<const Point> places, const Box& frame) const {
  if (metric == Metric::planar) return plane_diagram(places, frame);
  return geodesic_diagram(places, frame, share_for_chords * tolerance, accuracy_for_areas(), 1);
}

double Yardstick::accuracy_for_areas() const {
  return std::max(finest_accuracy, share_for_points * tolerance);
}

std::unique_ptr<Surface> Yardstick::surface() const {
  if (metric == Metric::planar) return std::make_unique<PlaneSurface>(unit_area);
  return std::make_unique<EllipsoidSurface>();
}

}  // namespace thiessen
