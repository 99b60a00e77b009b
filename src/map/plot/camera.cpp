#include "map/plot/camera.h"

#include <algorithm>
#include <cmath>

#include "map/plot/box_cut.h"
#include "map/sheet/map_shape.h"

namespace thiessen {

Camera::Camera(const SceneVector& eye, const SceneVector& direction, const SceneVector& half,
               const PixelBox& panel, Middle middle)
    : eye_(eye), middle_{panel.x + panel.width / 2.0, panel.y + panel.height / 2.0} {
  constexpr double along_z = 1e-6;
  constexpr double near = 0.02;  // in units of the points' range
  ahead_ = unit(direction);
  const bool is_along_z = std::hypot(ahead_[0], ahead_[1]) < along_z;
  right_ = unit(cross(ahead_, is_along_z ? SceneVector{0, 1, 0} : SceneVector{0, 0, 1}));
  up_ = cross(right_, ahead_);
  near_ = near;
  fit_box(half, panel, middle);
}

void Camera::fit_box(const SceneVector& half, const PixelBox& panel, Middle middle) {
  constexpr double filled = 0.84;        // share of the panel
  constexpr double longest_focus = 1e9;  // pixels; a box that this does not enlarge is too far off
  outside_ = !is_in_box<3>(eye_, half);
  nearest_ = HUGE_VAL;
  Extent range;
  for (int corner = 0; corner < 8; ++corner) {
    const SceneVector p =
        seen({(corner & 1) != 0 ? half[0] : -half[0], (corner & 2) != 0 ? half[1] : -half[1],
              (corner & 4) != 0 ? half[2] : -half[2]});
    nearest_ = std::min(nearest_, p[2]);
    farthest_ = std::max(farthest_, p[2]);
    if (p[2] <= near_) outside_ = false;
    range.add({p[0] / p[2], p[1] / p[2]});
  }
  nearest_ = std::max(nearest_, near_);
  farthest_ = std::max(farthest_, near_);
  focus_ = filled * std::min(panel.width, panel.height) / 2.0 / widest;
  if (!outside_) return;
  if (middle == Middle::straight_ahead) {
    const double across = std::max(std::abs(range.west), std::abs(range.east));
    const double upward = std::max(std::abs(range.south), std::abs(range.north));
    range = {-across, -upward, across, upward};
  }
  const double fitting =
      filled * std::min(panel.width / range.width(), panel.height / range.height());
  focus_ = std::clamp(fitting, focus_, longest_focus);
  middle_ = {middle_.x - focus_ * (range.west + range.width() / 2),
             middle_.y + focus_ * (range.south + range.height() / 2)};
}

SceneVector Camera::seen(const SceneVector& place) const {
  const SceneVector from_eye = place - eye_;
  return {dot(from_eye, right_), dot(from_eye, up_), dot(from_eye, ahead_)};
}

Point Camera::pixel(const SceneVector& seen) const {
  const double scale = focus_ / seen[2];
  return {middle_.x + seen[0] * scale, middle_.y - seen[1] * scale};
}

}  // namespace thiessen
