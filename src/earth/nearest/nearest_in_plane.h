#pragma once

#include <span>
#include <vector>

#include "earth/nearest/nearest_places.h"

namespace thiessen {

/// Finds the nearest places by straight distance in the coordinates. Requires coordinates in the
/// exact range of predicates.h.
class NearestInPlane : public NearestPlaces {
 public:
  explicit NearestInPlane(std::span<const Point> places);

  Direction in_space(Point p) const override { return {p.x, p.y, 0}; }
  double rounding(Direction at) const override;
  std::optional<PlaceIndex> nearest(Point p, std::span<const PlaceIndex> rivals) const override;

 private:
  Margin margin(double) const override { return {}; }
  double places_rounding() const override { return 0; }
  void refine(const Ball&, std::vector<PlaceIndex>&) const override {}

  std::vector<Point> places_;
};

}  // namespace thiessen
