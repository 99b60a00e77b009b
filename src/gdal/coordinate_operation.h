#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gdal/crs.h"
#include "gdal/operation_choice.h"
#include "gdal/proj_objects.h"
#include "geometry/box.h"
#include "geometry/point.h"

namespace thiessen {

/// Takes points from one CRS to another by one operation of PROJ's for all points, forth and back.
/// PROJ by itself may choose another operation for each point, by the areas for which they are
/// made; what lies on both sides of such an area's border would be torn apart by metres.
class CoordinateOperation {
 public:
  /// The best for the area: see choose_operation, whose errors are thrown.
  CoordinateOperation(const Crs& from, const Crs& to, const std::optional<Box>& area);
  /// See choose_rough_operation.
  static std::optional<CoordinateOperation> rough(const Crs& from);

  /// Points that cannot be transformed become NaN.
  void forth(std::vector<Point>& points) const;
  /// The inverse of `forth` to some nanometres: what PROJ takes for the inverse misses by up to a
  /// millimetre where datums are shifted or a projection is a series, and is mended. Cost: thrice
  /// that of `forth`.
  void back(std::vector<Point>& points) const;
  /// The inverse of `forth` to millimetres.
  void back_nearly(std::vector<Point>& points) const;

  const OperationChoice& choice() const { return choice_; }

 private:
  CoordinateOperation(const Crs& from, OperationChoice choice);
  void apply(std::vector<Point>& points, PJ_DIRECTION direction) const;

  OperationChoice choice_;
  ProjContext context_;
  ProjObject operation_;
  double turn_ = 0;  ///< of the longitudes in `from`; 0 where it is projected
};

}  // namespace thiessen
