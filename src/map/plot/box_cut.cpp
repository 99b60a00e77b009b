#include "map/plot/box_cut.h"

namespace thiessen {
namespace {

/// The part of the polygon in which `sign` times coordinate `axis` is at most `limit`.
std::vector<CoordinatesIn<3>> cut_off(const std::vector<CoordinatesIn<3>>& polygon,
                                      std::size_t axis, double sign, double limit) {
  std::vector<CoordinatesIn<3>> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const CoordinatesIn<3>& p = polygon[i];
    const CoordinatesIn<3>& q = polygon[(i + 1) % polygon.size()];
    const double p_over = sign * p[axis] - limit;
    const double q_over = sign * q[axis] - limit;
    if (p_over <= 0) kept.push_back(p);
    if ((p_over < 0 && q_over > 0) || (p_over > 0 && q_over < 0)) {
      const double t = p_over / (p_over - q_over);
      CoordinatesIn<3> between = p;
      for (std::size_t k = 0; k < 3; ++k) between[k] += t * (q[k] - p[k]);
      between[axis] = sign * limit;
      kept.push_back(between);
    }
  }
  return kept;
}

}  // namespace

std::vector<CoordinatesIn<3>> cut_to_box(std::vector<CoordinatesIn<3>> polygon,
                                         const CoordinatesIn<3>& half) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    polygon = cut_off(polygon, axis, 1, half[axis]);
    polygon = cut_off(polygon, axis, -1, half[axis]);
  }
  return polygon;
}

}  // namespace thiessen
