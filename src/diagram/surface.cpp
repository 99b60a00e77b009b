#include "diagram/surface.h"

#include <cstddef>

namespace thiessen {

void Surface::under_each(std::span<const Segment> segments, double reference,
                         std::vector<double>& areas) const {
  areas.clear();
  for (const auto& [from, to] : segments) areas.push_back(under(from, to, reference));
}

void PlaneSurface::under_each(std::span<const Segment> segments, double reference,
                              std::vector<double>& areas) const {
  areas.resize(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    areas[i] = PlaneSurface::under(segments[i].from, segments[i].to, reference);
}

double PlaneSurface::under(Point a, Point b, double reference) const {
  return (b.x - a.x) * ((a.y - reference) + (b.y - reference)) / 2 * unit_area_;
}

}  // namespace thiessen
