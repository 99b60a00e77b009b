#include "gdal/crs/coordinate_operation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace thiessen {
CoordinateOperation::CoordinateOperation(const Crs& from, const Crs& to,
                                         const std::optional<Box>& area)
    : CoordinateOperation(from, choose_operation(from, to, area)) {}

CoordinateOperation::CoordinateOperation(const Crs& from, OperationChoice choice)
    : choice_(std::move(choice)),
      context_(quiet_context()),
      operation_(proj_create(context_.get(), choice_.steps.c_str())),
      turn_(from.geographic() ? 360 / from.degrees_per_unit() : 0) {}

std::optional<CoordinateOperation> CoordinateOperation::rough(const Crs& from) {
  auto choice = choose_rough_operation(from);
  if (!choice) return std::nullopt;
  return CoordinateOperation(from, *std::move(choice));
}

void CoordinateOperation::apply(std::vector<Point>& points, PJ_DIRECTION direction) const {
  if (points.empty()) return;
  proj_trans_generic(operation_.get(), direction, &points[0].x, sizeof(Point), points.size(),
                     &points[0].y, sizeof(Point), points.size(), nullptr, 0, 0, nullptr, 0, 0);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (Point& p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) p = {none, none};
  }
}

void CoordinateOperation::forth(std::vector<Point>& points) const {
  apply(points, PJ_FWD);
}

void CoordinateOperation::back_nearly(std::vector<Point>& points) const {
  apply(points, PJ_INV);
}

void CoordinateOperation::back(std::vector<Point>& points) const {
  apply(points, PJ_INV);
  // PROJ's inverse misses by the same distance at a point and a little further on, so a second
  // round trip measures the error.
  std::vector<Point> again = points;
  apply(again, PJ_FWD);
  apply(again, PJ_INV);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double east = again[i].x - points[i].x;
    if (turn_ > 0) east = std::remainder(east, turn_);
    points[i] = {points[i].x - east, points[i].y - (again[i].y - points[i].y)};
  }
}

}  // namespace thiessen
