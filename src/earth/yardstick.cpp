#include "earth/yardstick.h"

#include "diagram/plane_diagram.h"
#include "diagram/plane_dual.h"
#include "earth/area/ellipsoid_surface.h"
#include "earth/cells/geodesic_diagram.h"
#include "earth/cells/geodesic_dual.h"

namespace thiessen {
namespace {

// The share of a tolerance that is for chords. The rest of it is for rounding to decimals when the
// cells are written.
constexpr double share_for_chords = 0.5;
constexpr double finest_accuracy = 1e-6;  // metres

}  // namespace

Diagram Yardstick::diagram(std::span<const Point> places, const Box& frame, unsigned threads,
                           Neighbours neighbours) const {
  if (metric == Metric::planar) return plane_diagram(places, frame);
  return geodesic_diagram(places, frame, share_for_chords * measuring_tolerance, finest_accuracy,
                          threads, neighbours);
}

Diagram Yardstick::drawn_diagram(std::span<const Point> places, const Box& frame, unsigned threads,
                                 Neighbours neighbours) const {
  if (metric == Metric::planar) return plane_diagram(places, frame);
  return geodesic_diagram(places, frame, share_for_chords * tolerance, finest_accuracy, threads,
                          neighbours);
}

Dual Yardstick::dual(std::span<const Point> places, unsigned threads) const {
  if (metric == Metric::planar) return plane_dual(places);
  return geodesic_dual(places, finest_accuracy, threads);
}

Diagram Yardstick::diagram_of_heirs(std::span<const Point> places, const Box& frame) const {
  if (metric == Metric::planar) return plane_diagram(places, frame);
  return geodesic_diagram(places, frame, share_for_chords * measuring_tolerance, accuracy_of_heirs,
                          1);
}

std::unique_ptr<Surface> Yardstick::surface() const {
  if (metric == Metric::planar) return std::make_unique<PlaneSurface>(unit_area);
  return std::make_unique<EllipsoidSurface>();
}

}  // namespace thiessen
