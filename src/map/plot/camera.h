#pragma once

#include <optional>

#include "map/ink/canvas.h"
#include "map/plot/scene_vector.h"

namespace thiessen {

/// Central projection of places in SceneCoordinates to pixels.
class Camera {
 public:
  /// What comes to the middle of the panel: what lies straight ahead, or the box, where all of it
  /// lies ahead.
  enum class Middle { straight_ahead, box };

  /// Looks from `eye` in a direction, z (or y, where one looks along z) upward. The box of these
  /// half sides about 0 fills the panel but for a margin, unless it would take a wider angle than
  /// `widest` to see it, some of it lies behind, or it is a billion times its size away. Requires
  /// eye != site.
  Camera(const SceneVector& eye, const SceneVector& direction, const SceneVector& half,
         const PixelBox& panel, Middle middle);

  static constexpr double widest = 0.9;  ///< the tangent of half the angle of view, at most

  /// To the right, upward and ahead of the eye.
  SceneVector seen(const SceneVector& place) const;
  /// Pixels of the page, of a place as seen. Requires it ahead of the near plane.
  Point pixel(const SceneVector& seen) const;
  /// Pixels to a unit at this distance ahead.
  double pixels_per_unit(double ahead) const { return focus_ / ahead; }
  /// Nothing nearer than this is shown.
  double near_plane() const { return near_; }
  /// How far ahead the box begins and ends, at least the near plane.
  double nearest() const { return nearest_; }
  double farthest() const { return farthest_; }
  /// Whether some of the box lies ahead.
  bool sees_box() const { return farthest_ > near_; }
  /// Whether the eye is off the box, with all of it ahead.
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
