#pragma once

#include <array>
#include <optional>

#include "geometry/direction.h"
#include "geometry/point.h"

namespace thiessen {

/// A place beside an edge: its direction on the conformal sphere, and the sphere's scale there.
struct EdgeSide {
  Direction direction;
  double scale;
};

/// A vertex at an end of an edge: its longitude and latitude in degrees, and its direction.
struct EdgeEnd {
  Point position;
  Direction direction;
};

/// The edge between the cells of two places that are near it, where it is so short that its
/// longitudes and latitudes are polynomials of the fourth degree.
class ShortEdge {
 public:
  /// The longest short edge, in radians: 12.7 km.
  static constexpr double longest = 2e-3;
  /// The latitude beyond which no edge is short, in degrees.
  static constexpr double highest_latitude = 75;

  /// Fits the edge from the vertex `start` to `end`, on the right and on the left of the way from
  /// the first place to the second, whose vector is `chord`. The result is empty where the edge is
  /// not short, or too far from the places: farther than Simpson's rule is right to a tenth of
  /// `accuracy` metres (see is_short_path), or than places near each other tell. Accuracy: 1e-5
  /// metres for its points, beside the accuracy of its ends; short_edge.cpp proves it. Requires
  /// ends less than half a turn apart in longitude. Cost: 0.2 microseconds.
  static std::optional<ShortEdge> fit(const EdgeSide& first, const EdgeSide& second,
                                      Direction chord, const EdgeEnd& start, const EdgeEnd& end,
                                      double accuracy);

  /// The angle along the great circle of the places from one end to the other, in radians.
  double length() const { return length_; }
  /// The edge's point at a share of its length, as longitude and latitude in degrees.
  Point at(double share) const { return {x_.at(share), y_.at(share)}; }
  /// The sine and the cosine of a latitude on the edge, in degrees. Accuracy: 1e-12.
  struct Latitude {
    double sine;
    double cosine;
  };
  Latitude latitude(double degrees) const;

 private:
  /// The polynomial through values at the two ends and at the quarters of the length.
  class Quartic {
   public:
    Quartic() = default;
    /// What the values at the quarters and at the end are more than the first.
    Quartic(double first, const std::array<double, 4>& more);
    double at(double share) const {
      const double t = 4 * share;
      return first_ + t * (differences_[0] +
                           (t - 1) * (differences_[1] +
                                      (t - 2) * (differences_[2] + (t - 3) * differences_[3])));
    }

   private:
    double first_ = 0;
    std::array<double, 4> differences_{};  // Newton's, divided by factorials
  };

  double length_ = 0;
  Quartic x_;
  Quartic y_;
  double middle_latitude_ = 0;  // degrees
  Latitude middle_{};
};

}  // namespace thiessen
