#pragma once

#include <span>
#include <vector>

#include "earth/nearest/nearest_places.h"

namespace thiessen {

/// Finds the nearest places by the geodesic on WGS 84, in longitude and latitude in degrees. Chords
/// through the Earth tell which of two places is nearer within the bounds of chord_bounds.h. Where
/// they do not, geodesics to the middle of a ball do, and least_difference extends what they tell
/// to the rest of the ball.
class NearestOnEarth : public NearestPlaces {
 public:
  explicit NearestOnEarth(std::span<const Point> places);

  Direction in_space(Point p) const override;
  double rounding(Direction) const override;
  std::optional<PlaceIndex> nearest(Point p, std::span<const PlaceIndex> rivals) const override;

 private:
  Margin margin(double farthest) const override;
  double places_rounding() const override;
  void refine(const Ball& ball, std::vector<PlaceIndex>& rivals) const override;

  std::vector<Point> places_;
};

}  // namespace thiessen
