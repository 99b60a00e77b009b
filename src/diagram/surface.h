#pragma once

#include "geometry/point.h"

namespace thiessen {

/// A surface on which areas are measured.
class Surface {
 public:
  virtual ~Surface() = default;
  /// The area between the segment a→b and the parallel `reference`; positive where the segment runs
  /// to the right (east) above the parallel. Laws: as those of area_under.
  virtual double under(Point a, Point b, double reference) const = 0;
};

/// The plane of the coordinates. Areas are in the square of their unit, times `unit_area`.
class PlaneSurface : public Surface {
 public:
  explicit PlaneSurface(double unit_area = 1) : unit_area_(unit_area) {}
  double under(Point a, Point b, double reference) const override;

 private:
  double unit_area_;
};

}  // namespace thiessen
