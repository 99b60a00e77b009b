#include "earth/nearest/nearest_in_plane.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace thiessen {
namespace {

std::vector<Direction> at_height_0(std::span<const Point> places) {
  std::vector<Direction> there;
  there.reserve(places.size());
  for (const Point p : places) there.push_back({p.x, p.y, 0});
  return there;
}

double in_exact_range_or_nearest(double coordinate) {
  if (std::abs(coordinate) < smallest_coordinate) return 0;
  return std::clamp(coordinate, -largest_coordinate, largest_coordinate);
}

}  // namespace

NearestInPlane::NearestInPlane(std::span<const Point> places)
    : NearestPlaces(at_height_0(places)), places_(places.begin(), places.end()) {}

double NearestInPlane::rounding(Direction at) const {
  return 0x1p-49 * std::max(std::abs(at.x), std::abs(at.y));
}

std::optional<PlaceIndex> NearestInPlane::nearest(Point p,
                                                  std::span<const PlaceIndex> rivals) const {
  p = {in_exact_range_or_nearest(p.x), in_exact_range_or_nearest(p.y)};
  PlaceIndex best = rivals.front();
  for (const PlaceIndex q : rivals) {
    const int nearer = compare_distance(p, places_[index(q)], places_[index(best)]);
    if (nearer < 0 || (nearer == 0 && q < best)) best = q;
  }
  return best;
}

}  // namespace thiessen
