#pragma once

#include "diagram/surface.h"

namespace thiessen {

/// The surface of the WGS 84 ellipsoid in longitude and latitude in degrees; areas are in square
/// metres.
class EllipsoidSurface : public Surface {
 public:
  double under(Point a, Point b, double reference) const override;
  void under_each(std::span<const Segment> segments, double reference,
                  std::vector<double>& areas) const override;
};

}  // namespace thiessen
