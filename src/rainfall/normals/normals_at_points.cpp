#include "rainfall/normals/normals_at_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace thiessen {
namespace {

double distance_to(const Box& box, Point p) {
  const double x = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
  const double y = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
  return std::hypot(x, y);
}

}  // namespace

NormalsAtPoints::NormalsAtPoints(const NormalField& normals, const std::vector<Basin>& basins,
                                 const NormalMonth& month, double period)
    : normals_(normals),
      month_(month),
      period_(period),
      reference_(reference_normal(normals, month)) {
  for (const Basin& basin : basins) {
    Box& box = boxes_.emplace_back();
    for (const Polygon& part : basin.shape) {
      for (const Point p : part.outer) box.take_in(p);
    }
    shapes_.push_back(std::make_unique<const Containment>(basin));
  }
}

double NormalsAtPoints::at(Point p) const {
  double least = std::numeric_limits<double>::infinity();
  double nearest = 1;
  const auto try_in = [&](std::size_t b, Point q) -> double {
    const double distance = distance_to(boxes_[b], q);
    if (distance < least) {
      least = distance;
      nearest = basin_normal(normals_, b, month_);
    }
    if (distance > 0) return std::numeric_limits<double>::quiet_NaN();
    const bool is_uniform = normals_.in(b).is_uniform();
    const double normal =
        is_uniform ? std::numeric_limits<double>::quiet_NaN() : normal_at(normals_, b, q, month_);
    if (!std::isnan(normal) || !shapes_[b]->contains(q)) return normal;
    return basin_normal(normals_, b, month_);
  };
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    const double turns = period_ > 0 ? std::round((boxes_[b].centre().x - p.x) / period_) : 0;
    const double normal = try_in(b, {p.x + turns * period_, p.y});
    if (!std::isnan(normal)) return normal / reference_;
  }
  return nearest / reference_;
}

}  // namespace thiessen
