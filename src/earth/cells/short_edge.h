#pragma once

#include <optional>

#include "geometry/direction.h"
#include "geometry/point.h"

namespace thiessen {

/// A vertex at an end of an edge: its longitude and latitude in degrees, and its direction.
struct EdgeEnd {
  Point position;
  Direction direction;
};

/// The edge between the cells of two places that are near it, where it is so short that its
/// longitudes and latitudes are polynomials of the fourth degree.
class ShortEdge {
 public:
  /// The longest short edge, in radians: 25 km, and less beyond 55 degrees of latitude.
  static constexpr double longest = 4e-3;
  /// The latitude beyond which no edge is short, in degrees.
  static constexpr double highest_latitude = 75;

  /// Fits the edge from the vertex `start` to `end`, on the right and on the left of the way from
  /// the place at the direction `first` to that at `second`. The result is empty where the edge is
  /// not short, or far from the places. Accuracy: 1e-5 metres for its points, 3e-5 along it, beside
  /// the accuracy of its ends; short_edge.cpp proves it. Requires ends less than half a turn apart
  /// in longitude. Cost: 30 nanoseconds.
  static std::optional<ShortEdge> fit(Direction first, Direction second, const EdgeEnd& start,
                                      const EdgeEnd& end);

  /// The angle between the ends, in radians.
  double length() const { return length_; }
  /// The edge's point at a share of its angle, as longitude and latitude in degrees.
  Point at(double share) const {
    const double angle = share - 0.5;
    const double along = angle + stretch_ * (angle * angle - 0.25);
    const double square = along * along - 0.25;
    const double bend = square / 2;
    const double twist = along * square / 6;
    const double fourth = square * (square + 0.5) / 24;
    return {middle_.x + along * way_.x + bend * bend_.x + twist * twist_.x + fourth * fourth_.x,
            middle_.y + along * way_.y + bend * bend_.y + twist * twist_.y + fourth * fourth_.y};
  }
  /// How far, in metres, the middles of a piece of it and of the piece's halves lie to the right of
  /// their chords.
  struct Bend {
    double whole;
    double first;
    double last;
  };
  Bend bend() const;
  /// The area in square metres between the edge and a chord of it, of a share `part` of its length
  /// round the share `middle`: positive where the edge lies to the right.
  double area_beside_chord(double middle, double part) const;

 private:
  struct Piece;
  /// A piece round the share 0.5 + `along`.
  Piece piece(double along, double part) const;

  double length_ = 0;
  double stretch_ = 0;  // what a share of the angle is more than that of the metres
  Point middle_;        // of the line between the ends, in degrees
  Point way_;           // between the ends
  Point bend_;          // the second derivative by the share, at the middle
  Point twist_;         // the third one
  Point fourth_;
  double sine_ = 0;  // of the latitude of the middle
  double cosine_ = 0;
};

}  // namespace thiessen
