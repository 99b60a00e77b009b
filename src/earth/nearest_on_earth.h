#pragma once

#include <span>
#include <vector>

#include "earth/nearest_places.h"

namespace thiessen {

/// By the geodesic on WGS 84, longitudes and latitudes in degrees. Chords through the Earth tell
/// which of two places is nearer as far as chord_bounds.h says; where they do not, geodesics to the
/// middle of a ball do, as far as least_difference says of the rest.
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
