#pragma once

#include <cmath>
#include <cstdlib>
#include <vector>

#include "earth/conformal_sphere.h"
#include "tessellation/topology.h"

namespace thiessen {

/// The area of a triangle of the unit sphere, positive where its corners are seen counter-clockwise
/// from outside; less than half the sphere. Accuracy: 1e-12 of it, and 1e-16 of its longest side.
/// Source: F. Eriksson, On the measure of solid angles, 1990.
inline double spherical_area(Direction a, Direction b, Direction c) {
  const double volume = dot(a, cross(b - a, c - a));
  const double t = volume / (1 + dot(a, b) + dot(b, c) + dot(c, a));
  if (std::abs(t) < 0.01) return 2 * t * (1 - t * t * (1. / 3 - t * t * (1. / 5 - t * t / 7)));
  return 2 * std::atan2(volume, 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

/// The vertices of a tessellation of the sphere, for find_stolen_areas.
class SphereCentres {
 public:
  /// `gauges`: by point, where they are on the sphere.
  void take(const Topology<2>& topology, const std::vector<Direction>& gauges) {
    centres_.resize(topology.size());
    topology.for_each_vertex([&](VertexId v) {
      if (topology.is_infinite(v)) return;
      const auto& forming = topology.forming(v);
      centres_[index(v)] =
          centre(gauges[index(forming[0])], gauges[index(forming[1])], gauges[index(forming[2])]);
    });
  }

  /// With a point that comes.
  class Seen {
   public:
    using Centre = Direction;
    Seen(const SphereCentres& all, const std::vector<Direction>& gauges, Direction from)
        : all_(all), gauges_(gauges), from_(from) {}

    Direction old(VertexId v) const { return all_.centres_[index(v)]; }
    Direction fresh(PointId p, PointId q) const {
      return centre(from_, gauges_[index(p)], gauges_[index(q)]);
    }
    static double area(Direction a, Direction b, Direction c) { return spherical_area(a, b, c); }

   private:
    const SphereCentres& all_;
    const std::vector<Direction>& gauges_;
    Direction from_;
  };

 private:
  static Direction centre(Direction a, Direction b, Direction c) {
    return unit(cross(b - a, c - a));
  }

  std::vector<Direction> centres_;  // by vertex
};

}  // namespace thiessen
