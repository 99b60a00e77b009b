#pragma once

#include <memory>
#include <vector>

#include "basin/basin.h"
#include "basin/containment.h"
#include "geometry/box.h"
#include "rainfall/normals/normal_field.h"

namespace thiessen {

/// The normals at any points of a study, whichever basin they lie in, in one month or the year,
/// relative to that of the first station. A
/// point of a basin without a normal has the basin's mean; one beyond all basins that has none has
/// that of the basin whose box is nearest. Safe for several threads at once. Cost of a point: the
/// basins' boxes, and a test by Containment where a raster has no value there.
class NormalsAtPoints {
 public:
  /// The field and the basins must outlive it. Where `period` is above 0, x repeats after it.
  NormalsAtPoints(const NormalField& normals, const std::vector<Basin>& basins,
                  const NormalMonth& month, double period);
  double at(Point p) const;

 private:
  const NormalField& normals_;
  NormalMonth month_;
  double period_;
  double reference_;
  std::vector<Box> boxes_;
  std::vector<std::unique_ptr<const Containment>> shapes_;
};

}  // namespace thiessen
