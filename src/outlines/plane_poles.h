#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "outlines/mapping.h"

namespace thiessen {

/// A vertex of a ring in a plane, or the place where one of its edges passes a pole.
struct RingNode {
  Point at;
  double pole = 0;  ///< the pole's latitude, where the node is at one; else 0
};

/// The positions of the poles in a projection, as far as it reaches them.
class PlanePoles {
 public:
  /// A pole's position in the plane, and its latitude, -90 or 90.
  struct Pole {
    Point at;
    double latitude;
  };

  /// No poles, for coordinates that are not those of a plane.
  PlanePoles() = default;
  /// Finds the poles. Requires a mapping of WGS 84 longitude and latitude in degrees to a plane.
  /// Accuracy: the projection's, and 1e-6 metres where it fails at the pole itself.
  explicit PlanePoles(const Mapping& to_plane);

  const std::vector<Pole>& all() const { return poles_; }
  /// The ring's vertices in order, and the poles on its edges. A point within 1e-6 metres of a pole
  /// is taken to be at it, and such points that follow each other become one. Cost: linear.
  std::vector<RingNode> nodes_of(const Ring& ring) const;
  /// Whether a pole lies within `metres` of a point of the plane.
  bool any_within(double metres, Point point) const;

 private:
  const Pole* pole_at(Point point) const;

  double metres_per_unit_ = 1;
  double reach_ = 0;  // how near counts as at a pole, in the plane's unit
  std::vector<Pole> poles_;
};

}  // namespace thiessen
