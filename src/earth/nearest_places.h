#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "earth/place_tree.h"
#include "earth/yardstick.h"

namespace thiessen {

/// Finds the nearest of some places: for many points at once, the rivals that may be nearest to one
/// of a ball's, as long as there are several of them, in ever smaller balls; and at last of those
/// the nearest to a point. Balls are of space, where a place of the plane is at height 0, and one
/// of the Earth on the ellipsoid, in metres from its centre. Safe for several threads at once.
class NearestPlaces {
 public:
  virtual ~NearestPlaces() = default;

  virtual Direction in_space(Point p) const = 0;
  /// How far in_space may be off, and more, near a point of space.
  virtual double rounding(Direction at) const = 0;

  /// Every place that may be nearest to a point of the plane, or of the Earth, within the ball.
  /// Cost: log n and what it finds, where places lie scattered; on the Earth also a geodesic for
  /// each, 1 microsecond, where chords do not tell.
  void find_rivals(const Ball& ball, std::vector<PlaceIndex>& rivals) const;
  /// The same of `among`, which holds those of a ball around this one; in their order.
  void keep_rivals(const Ball& ball, std::span<const PlaceIndex> among,
                   std::vector<PlaceIndex>& rivals) const;
  /// The nearest of the rivals, the first of them by number where several are as near; none where p
  /// is not on the Earth. Planar: exact. Geodesic: by Karney's distances on WGS 84, which are right
  /// to 15 nanometres; equal where they are within 50. Cost: one distance each.
  virtual std::optional<PlaceIndex> nearest(Point p, std::span<const PlaceIndex> rivals) const = 0;

 protected:
  /// What the square of another place's distance in space must exceed that of the nearest, which is
  /// `farthest` or less, by, for it to be farther away for certain.
  struct Margin {
    double excess = 0;
    /// Or, for places no more than an eighth of `farthest` apart: so much and this for each two
    /// units between them.
    double excess_of_near = 0;
    double apiece = 0;
  };

  explicit NearestPlaces(std::vector<Direction> places) : tree_(std::move(places)) {}
  Direction place(PlaceIndex p) const { return tree_[p]; }

 private:
  virtual Margin margin(double farthest) const = 0;
  /// How far the places themselves are off in space.
  virtual double places_rounding() const = 0;
  /// Takes out those that lose everywhere in the ball, told otherwise than by space.
  virtual void refine(const Ball& ball, std::vector<PlaceIndex>& rivals) const = 0;

  class Winner;
  Winner winner_of(const Ball& ball, PlaceIndex nearest) const;
  void settle(const Winner& winner, const Ball& ball, std::vector<PlaceIndex>& rivals) const;

  PlaceTree tree_;
};

/// Requires at least one place, different ones; planar: coordinates in the exact range of
/// predicates.h.
std::unique_ptr<NearestPlaces> nearest_places(std::span<const Point> places, Metric metric);

}  // namespace thiessen
