#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gdal/crs/crs.h"
#include "gdal/crs/operation_choice.h"
#include "gdal/crs/proj_objects.h"
#include "geometry/box.h"
#include "geometry/point.h"

namespace thiessen {

/// Transforms points from one CRS to another, forth and back, by one operation of PROJ's for all
/// points. PROJ by itself may choose another operation for each point, by the areas for which
/// operations are made; shapes on both sides of such an area's border would then be torn apart by
/// metres.
class CoordinateOperation {
 public:
  /// The best operation for the area; choose_operation chooses it, and its errors are thrown.
  CoordinateOperation(const Crs& from, const Crs& to, const std::optional<Box>& area);
  /// The operation of choose_rough_operation; empty where there is none.
  static std::optional<CoordinateOperation> rough(const Crs& from);

  /// Transforms points in place. Points that cannot be transformed become NaN.
  void forth(std::vector<Point>& points) const;
  /// Transforms points back in place: the inverse of `forth` to some nanometres. The inverse that
  /// PROJ computes misses by up to a millimetre where datums are shifted or a projection is a
  /// series, so it is corrected. Cost: three times that of `forth`.
  void back(std::vector<Point>& points) const;
  /// Transforms points back in place: the inverse of `forth` to millimetres.
  void back_nearly(std::vector<Point>& points) const;

  const OperationChoice& choice() const { return choice_; }

 private:
  CoordinateOperation(const Crs& from, OperationChoice choice);
  void apply(std::vector<Point>& points, PJ_DIRECTION direction) const;

  OperationChoice choice_;
  ProjContext context_;
  ProjObject operation_;
  double turn_ = 0;  ///< a whole turn of longitude in units of `from`; 0 where it is projected
};

}  // namespace thiessen
