#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "earth/nearest/place_tree.h"
#include "earth/yardstick.h"

namespace thiessen {

/// Tells from which difference on the squares of two places' distances in space decide which of the
/// two is nearer, at points whose positions may be off and whose nearest place is not too far away.
class CertainDifference {
 public:
  /// The difference that is certain for two places, from the square of the distance between them.
  double at(double square_apart) const {
    const double apart = std::sqrt(square_apart);
    const double any = excess_ + apart * apiece_;
    return apart <= near_ ? std::min(any, excess_of_near_ + apart * apiece_of_near_) : any;
  }

 private:
  friend class NearestPlaces;

  double excess_ = 0;
  double apiece_ = 0;  ///< for each unit between the two places
  double near_ = 0;    ///< up to which distance between them the smaller excess holds
  double excess_of_near_ = 0;
  double apiece_of_near_ = 0;
};

/// Finds the nearest of some places. For many points at once, it finds the rivals: the places that
/// may be nearest to some point of a ball. As long as there are several rivals, the search goes on
/// in ever smaller balls, and at last the nearest of them to a point is found. Balls are in space,
/// where a place of the plane is at height 0 and one of the Earth on the ellipsoid, in metres from
/// its centre. Safe for several threads at once.
class NearestPlaces {
 public:
  virtual ~NearestPlaces() = default;

  /// The position in space of a point of the plane or of the Earth.
  virtual Direction in_space(Point p) const = 0;
  /// An upper bound on how far in_space may be off near a point of space.
  virtual double rounding(Direction at) const = 0;

  /// Finds every place that may be nearest to a point of the plane, or of the Earth, within the
  /// ball. Cost: log n and the number of rivals, where places lie scattered; on the Earth also a
  /// geodesic, 1 microsecond, for each rival where chords do not tell.
  void find_rivals(const Ball& ball, std::vector<PlaceIndex>& rivals) const;
  /// Finds the rivals for a ball from `among`, which holds those for a ball around this one; they
  /// stay in their order.
  void keep_rivals(const Ball& ball, std::span<const PlaceIndex> among,
                   std::vector<PlaceIndex>& rivals) const;
  /// The position of a place in space.
  Direction place(PlaceIndex p) const { return tree_[p]; }
  /// The certain differences at points that are known to within `off`, and whose nearest place is
  /// no more than `farthest` away. They do not allow for the rounding of the squares.
  CertainDifference certain_difference(double farthest, double off) const;
  /// The nearest of the rivals to p, the first of them by number where several are equally near;
  /// empty where p is not on the Earth. Planar: exact. Geodesic: by Karney's distances on WGS 84,
  /// which are right to 15 nanometres; they count as equal within 50. Cost: one distance for each
  /// rival.
  virtual std::optional<PlaceIndex> nearest(Point p, std::span<const PlaceIndex> rivals) const = 0;

 protected:
  /// The margin by which the square of another place's distance in space must exceed that of the
  /// nearest place, which is `farthest` away or less, for the other to be farther away for certain.
  struct Margin {
    double excess = 0;
    /// The margin of places that are no more than an eighth of `farthest` apart. It is smaller:
    /// this much, and `apiece` for each two units between them.
    double excess_of_near = 0;
    double apiece = 0;
  };

  explicit NearestPlaces(std::vector<Direction> places) : tree_(std::move(places)) {}

 private:
  virtual Margin margin(double farthest) const = 0;
  /// How far the places' own positions in space are off.
  virtual double places_rounding() const = 0;
  /// Takes out the rivals that are farther than another everywhere in the ball by a finer test than
  /// distances in space.
  virtual void refine(const Ball& ball, std::vector<PlaceIndex>& rivals) const = 0;

  class Winner;
  Winner winner_of(const Ball& ball, PlaceIndex nearest) const;
  void settle(const Winner& winner, const Ball& ball, std::vector<PlaceIndex>& rivals) const;

  PlaceTree tree_;
};

/// Makes the search that suits the metric. Requires at least one place, different ones; planar:
/// coordinates in the exact range of predicates.h.
std::unique_ptr<NearestPlaces> nearest_places(std::span<const Point> places, Metric metric);

}  // namespace thiessen
