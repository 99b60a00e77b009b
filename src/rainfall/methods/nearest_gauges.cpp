#include "rainfall/methods/nearest_gauges.h"

#include <algorithm>
#include <cmath>

#include "earth/nearest/in_space.h"

namespace thiessen {

NearestGauges::NearestGauges(std::span<const Point> places, Metric metric)
    : places_(places.begin(), places.end()), metric_(metric) {
  std::vector<Direction> there;
  there.reserve(places.size());
  for (const Point p : places) there.push_back(in_space(p, metric));
  tree_ = std::make_unique<const PlaceTree>(std::move(there));
}

void NearestGauges::find(Point from, std::size_t count, const ReportingPlaces& reports,
                         std::vector<Near>& near) const {
  const Direction at = in_space(from, metric_);
  const auto square_to = [&](PlaceIndex p) {
    const Direction way = (*tree_)[p] - at;
    return dot(way, way);
  };
  const auto is_wanted = [&](PlaceIndex p) { return reports.empty() || reports[p]; };
  // Any places, if they are as many as are wanted, bound the distance of the search from its start.
  double farthest = HUGE_VAL;
  std::erase_if(near, [&](const Near& n) { return !is_wanted(n.place); });
  if (near.size() >= count) {
    farthest = 0;
    for (std::size_t i = 0; i < count; ++i) farthest = std::max(farthest, square_to(near[i].place));
  }
  find_near_places(
      *tree_, at, count, farthest, is_wanted,
      [&](PlaceIndex a, PlaceIndex b) { return places_[index(a)] < places_[index(b)]; }, near);
}

}  // namespace thiessen
