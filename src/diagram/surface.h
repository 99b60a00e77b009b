#pragma once

#include <span>
#include <vector>

#include "geometry/point.h"
#include "geometry/segment.h"

namespace thiessen {

/// A surface on which areas are measured.
class Surface {
 public:
  virtual ~Surface() = default;
  /// The area between the segment a→b and the parallel `reference`; positive where the segment runs
  /// to the right (east) above the parallel. Laws: as those of area_under.
  virtual double under(Point a, Point b, double reference) const = 0;
  /// The same for each of some segments, which takes less than one by one.
  virtual void under_each(std::span<const Segment> segments, double reference,
                          std::vector<double>& areas) const;
};

/// The plane of the coordinates. Areas are in the square of their unit, times `unit_area`.
class PlaneSurface : public Surface {
 public:
  explicit PlaneSurface(double unit_area = 1) : unit_area_(unit_area) {}
  double under(Point a, Point b, double reference) const override;
  void under_each(std::span<const Segment> segments, double reference,
                  std::vector<double>& areas) const override;

 private:
  double unit_area_;
};

}  // namespace thiessen
