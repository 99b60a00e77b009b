#pragma once

#include "diagram/surface.h"

namespace thiessen {

/// The WGS 84 ellipsoid under longitudes and latitudes in degrees; areas in square metres.
class EllipsoidSurface : public Surface {
 public:
  double under(Point a, Point b, double reference) const override;
};

}  // namespace thiessen
