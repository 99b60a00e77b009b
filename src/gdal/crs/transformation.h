#pragma once

#include <memory>
#include <vector>

#include "gdal/crs/crs.h"
#include "gdal/crs/operation_choice.h"
#include "geometry/point.h"
#include "outlines/mapping.h"

namespace thiessen {

/// Takes points from one CRS to another, vertex by vertex, by one operation for all (see
/// CoordinateOperation): the best for the area over which either CRS is used.
///
/// Every answer is proved, because projections give finite nonsense outside their area. A point
/// lies outside the projection's area where the inverse misses it by more than 0.1 m (within the
/// area it misses by less than 1 mm), or where it is farther than 20 degrees from the area for
/// which the CRS is made. Not safe for two threads at once.
class Transformation : public Mapping {
 public:
  /// Throws Error where no transformation of datum is known, naming both CRSs.
  Transformation(const Crs& from, const Crs& to);
  ~Transformation() override;
  Transformation(Transformation&&) noexcept;
  Transformation& operator=(Transformation&&) noexcept;

  CoordinateKind from() const override;
  CoordinateKind to() const override;
  /// Whether both sides are the same CRS.
  bool identity() const override;
  /// Transforms all points in place, with proof. Cost: up to four projections a point.
  std::vector<bool> apply(std::vector<Point>& points) const override;
  /// Transforms all points in place without proof. Cost: one projection a point, because the
  /// inverse is not computed.
  void apply_unproved(std::vector<Point>& points) const override;
  /// The operation by which the points go; null where both sides have the same CRS.
  const OperationChoice* choice() const;

 private:
  struct Proj;
  std::unique_ptr<Proj> proj_;
};

/// Takes points to WGS 84 longitude and latitude in degrees, in place, to a kilometre or so: see
/// choose_rough_operation. False, and the points stay, where that cannot be done.
bool take_roughly_to_degrees(const Crs& from, std::vector<Point>& points);

}  // namespace thiessen
