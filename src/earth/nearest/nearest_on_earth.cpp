#include "earth/nearest/nearest_on_earth.h"

#include <algorithm>
#include <cmath>

#include "earth/sphere/chord_bounds.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

/// Places whose distances differ by less than so many metres are equally near; it is more than the
/// distances' own rounding.
constexpr double equally_near = 5e-8;
/// An upper bound, in metres, on how far positions and distances may be off together; it is also
/// more than equally_near.
constexpr double noise = 2e-7;

std::vector<Direction> all_on_ellipsoid(std::span<const Point> places) {
  std::vector<Direction> there;
  there.reserve(places.size());
  for (const Point p : places) there.push_back(on_ellipsoid(p));
  return there;
}

}  // namespace

NearestOnEarth::NearestOnEarth(std::span<const Point> places)
    : NearestPlaces(all_on_ellipsoid(places)), places_(places.begin(), places.end()) {}

Direction NearestOnEarth::in_space(Point p) const {
  return on_ellipsoid(p);
}

double NearestOnEarth::rounding(Direction) const {
  return noise;
}

double NearestOnEarth::places_rounding() const {
  return noise;
}

NearestPlaces::Margin NearestOnEarth::margin(double farthest) const {
  const double noises = 4 * noise * farthest;
  return {least_certain_excess(farthest) + noises, noises, least_certain_excess_apiece(farthest)};
}

void NearestOnEarth::refine(const Ball& ball, std::vector<PlaceIndex>& rivals) const {
  constexpr double too_wide = 1e6;
  if (ball.radius > too_wide) return;
  const FootPoint centre = below(ball.centre);
  const double reach = longest_over_chord(ball.radius + centre.height) + noise;
  std::vector<Arrival> arrivals;
  arrivals.reserve(rivals.size());
  for (const PlaceIndex q : rivals) arrivals.push_back(arrival(places_[index(q)], centre.position));
  const auto nearest =
      std::min_element(arrivals.begin(), arrivals.end(),
                       [](const Arrival& a, const Arrival& b) { return a.distance < b.distance; });
  const Arrival winner = *nearest;
  const Direction its_place = place(rivals[static_cast<std::size_t>(nearest - arrivals.begin())]);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    const double apart = longest_over_chord(length(place(rivals[i]) - its_place)) + noise;
    if (least_difference(winner, arrivals[i], apart, reach) <= noise) rivals[kept++] = rivals[i];
  }
  rivals.resize(kept);
}

std::optional<PlaceIndex> NearestOnEarth::nearest(Point p,
                                                  std::span<const PlaceIndex> rivals) const {
  if (!(std::abs(p.y) <= 90)) return {};
  std::vector<double> distances;
  distances.reserve(rivals.size());
  for (const PlaceIndex q : rivals) distances.push_back(geodesic_distance(places_[index(q)], p));
  const double least = *std::min_element(distances.begin(), distances.end());
  std::optional<PlaceIndex> first;
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    if (distances[i] <= least + equally_near && (!first || rivals[i] < *first)) first = rivals[i];
  }
  return first;
}

}  // namespace thiessen
