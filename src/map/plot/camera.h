#pragma once

#include <optional>

#include "map/ink/canvas.h"
#include "map/plot/scene_vector.h"

namespace thiessen {

/// Projects places in SceneCoordinates centrally to pixels.
class Camera {
 public:
  /// What is shown in the middle of the panel: the place straight ahead, or the box, which needs
  /// all of the box ahead.
  enum class Middle { straight_ahead, box };

  /// Looks from `eye` in `direction`, with z upward, or y where one looks along z. The box about 0
  /// of these half sides fills the panel but for a margin, unless it would take a wider angle than
  /// `widest` to see it, a part of it lies behind, or it is a billion times its size away. Requires
  /// a direction that is not 0.
  Camera(const SceneVector& eye, const SceneVector& direction, const SceneVector& half,
         const PixelBox& panel, Middle middle);

  static constexpr double widest = 0.9;  ///< the tangent of half the angle of view, at most

  /// The coordinates of a place to the right of the eye, above it and ahead of it.
  SceneVector seen(const SceneVector& place) const;
  /// The pixel of the page at which a place, given as seen, appears. Requires it to be ahead of the
  /// near plane.
  Point pixel(const SceneVector& seen) const;
  /// The number of pixels to a unit of the scene at this distance ahead.
  double pixels_per_unit(double ahead) const { return focus_ / ahead; }
  /// The distance ahead below which nothing is shown.
  double near_plane() const { return near_; }
  /// The distances ahead at which the box begins and ends, not less than the near plane.
  double nearest() const { return nearest_; }
  double farthest() const { return farthest_; }
  /// Whether some of the box lies ahead of the near plane.
  bool sees_box() const { return farthest_ > near_; }
  /// Whether the eye is outside the box and all of the box lies ahead.
  bool is_outside() const { return outside_; }

 private:
  void fit_box(const SceneVector& half, const PixelBox& panel, Middle middle);

  SceneVector eye_;
  SceneVector right_;
  SceneVector up_;
  SceneVector ahead_;
  Point middle_;
  double focus_ = 0;
  double near_ = 0;
  double nearest_ = 0;
  double farthest_ = 0;
  bool outside_ = true;
};

}  // namespace thiessen
