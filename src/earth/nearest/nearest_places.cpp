#include "earth/nearest/nearest_places.h"

#include <algorithm>
#include <cmath>

#include "earth/nearest/nearest_in_plane.h"
#include "earth/nearest/nearest_on_earth.h"

namespace thiessen {

/// The place nearest to a ball's centre. Another place loses to it everywhere in the ball where the
/// difference of the squares of both distances, which is linear, is positive throughout.
class NearestPlaces::Winner {
 public:
  /// `off` is how far the ball's points and the places may be off.
  Winner(const Ball& ball, Direction place, double off)
      : centre_(ball.centre),
        place_(place),
        square_(dot(place - ball.centre, place - ball.centre)),
        reach_(ball.radius + off + relative_rounding * std::sqrt(square_)) {}

  /// An upper bound on the distance from any point of the ball to its nearest place.
  double farthest() const { return std::sqrt(square_) + reach_; }
  void set_margin(const Margin& margin) {
    margin_ = margin;
    near_ = farthest() / 8;
  }

  bool beats(Direction other) const {
    const Direction apart = other - place_;
    return beats(dot(apart, (place_ - centre_) + (other - centre_)), dot(apart, apart));
  }
  bool beats_but_for_margin(Direction other) const {
    const Direction apart = other - place_;
    return exceeds(dot(apart, (place_ - centre_) + (other - centre_)), reach_, dot(apart, apart));
  }
  /// Whether the winner beats all places within another ball.
  bool beats(const Ball& others) const {
    const double gap = length(others.centre - centre_) - others.radius;
    const double apart = length(others.centre - place_) + others.radius;
    return gap > 0 && beats((1 - relative_rounding) * gap * gap - square_, apart * apart);
  }

 private:
  static constexpr double relative_rounding = 0x1p-46;

  /// Whether the difference of the squares at the ball's centre is enough for places that far
  /// apart.
  bool beats(double difference, double square_apart) const {
    return exceeds(difference - margin_.excess, reach_, square_apart) ||
           (square_apart <= near_ * near_ &&
            exceeds(difference - margin_.excess_of_near, reach_ + margin_.apiece, square_apart));
  }
  static bool exceeds(double difference, double reach, double square_apart) {
    return difference > 0 && difference * difference > 4 * reach * reach * square_apart;
  }

  Direction centre_;
  Direction place_;
  double square_;
  double reach_;
  double near_ = 0;
  Margin margin_;
};

NearestPlaces::Winner NearestPlaces::winner_of(const Ball& ball, PlaceIndex nearest) const {
  Winner winner(ball, tree_[nearest], places_rounding());
  winner.set_margin(margin(winner.farthest()));
  return winner;
}

// This is what Winner::beats asks for, at a point instead of in a ball.
CertainDifference NearestPlaces::certain_difference(double farthest, double off) const {
  const double reach = off + places_rounding();
  const Margin margin = this->margin(farthest);
  CertainDifference certain;
  certain.excess_ = margin.excess;
  certain.apiece_ = 2 * reach;
  certain.near_ = farthest / 8;
  certain.excess_of_near_ = margin.excess_of_near;
  certain.apiece_of_near_ = 2 * (reach + margin.apiece);
  return certain;
}

// Refines the rivals where a smaller ball would not help: where only the margin keeps a place. As
// long as the margin keeps fewer than half of them, smaller balls are cheaper.
void NearestPlaces::settle(const Winner& winner, const Ball& ball,
                           std::vector<PlaceIndex>& rivals) const {
  if (rivals.size() < 2 || ball.radius == 0) return;
  const auto kept_by_margin = std::count_if(rivals.begin(), rivals.end(), [&](PlaceIndex p) {
    return winner.beats_but_for_margin(tree_[p]);
  });
  if (2 * kept_by_margin >= std::ssize(rivals) - 1) refine(ball, rivals);
}

void NearestPlaces::find_rivals(const Ball& ball, std::vector<PlaceIndex>& rivals) const {
  rivals.clear();
  const PlaceIndex nearest = tree_.nearest(ball.centre);
  const Winner winner = winner_of(ball, nearest);
  tree_.search([&](const Ball& part) { return winner.beats(part); },
               [&](PlaceIndex p) {
                 if (p == nearest || !winner.beats(tree_[p])) rivals.push_back(p);
               });
  std::sort(rivals.begin(), rivals.end());
  settle(winner, ball, rivals);
}

void NearestPlaces::keep_rivals(const Ball& ball, std::span<const PlaceIndex> among,
                                std::vector<PlaceIndex>& rivals) const {
  rivals.clear();
  PlaceIndex nearest = among.front();
  double square = HUGE_VAL;
  for (const PlaceIndex p : among) {
    const Direction way = tree_[p] - ball.centre;
    if (!(dot(way, way) < square)) continue;
    square = dot(way, way);
    nearest = p;
  }
  const Winner winner = winner_of(ball, nearest);
  for (const PlaceIndex p : among) {
    if (p == nearest || !winner.beats(tree_[p])) rivals.push_back(p);
  }
  settle(winner, ball, rivals);
}

std::unique_ptr<NearestPlaces> nearest_places(std::span<const Point> places, Metric metric) {
  if (metric == Metric::planar) return std::make_unique<NearestInPlane>(places);
  return std::make_unique<NearestOnEarth>(places);
}

}  // namespace thiessen
