#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "outlines/mapping.h"

namespace thiessen {

/// A vertex of a ring in a plane, or where one of its edges passes a pole.
struct RingNode {
  Point at;
  double pole = 0;  ///< the pole's latitude, where the node is at one; else 0
};

/// Where a projection has the poles, as far as it reaches them.
class PlanePoles {
 public:
  struct Pole {
    Point at;
    double latitude;
  };

  /// None: for coordinates that are no plane's.
  PlanePoles() = default;
  /// Requires a mapping of WGS 84 longitude and latitude in degrees to a plane. Accuracy: the
  /// projection's, and 1e-6 metres where it fails at the pole itself.
  explicit PlanePoles(const Mapping& to_plane);

  const std::vector<Pole>& all() const { return poles_; }
  /// The ring's vertices in order, and the poles on its edges; what is within 1e-6 metres of a pole
  /// is at it, and points there that follow each other are one. Cost: linear.
  std::vector<RingNode> nodes_of(const Ring& ring) const;
  /// Whether a pole is no farther than so many metres.
  bool any_within(double metres, Point point) const;

 private:
  const Pole* pole_at(Point point) const;

  double metres_per_unit_ = 1;
  double reach_ = 0;  // of a pole, in the plane's unit
  std::vector<Pole> poles_;
};

}  // namespace thiessen
