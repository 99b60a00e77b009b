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

bool NearestGauges::comes_before(const Near& a, const Near& b) const {
  if (a.square != b.square) return a.square < b.square;
  return places_[index(a.place)] < places_[index(b.place)];
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
  near.clear();
  const auto before = [&](const Near& a, const Near& b) { return comes_before(a, b); };
  constexpr double rounding = 1e-14;
  tree_->search(
      [&](const Ball& ball) {
        const Direction way = ball.centre - at;
        const double distance = std::sqrt(dot(way, way));
        const double gap = distance - ball.radius - rounding * (distance + ball.radius);
        return gap > 0 && gap * gap > farthest;
      },
      [&](PlaceIndex p) {
        const double square = square_to(p);
        if (square > farthest || !is_wanted(p)) return;
        near.push_back({p, square});
        std::push_heap(near.begin(), near.end(), before);
        if (near.size() > count) {
          std::pop_heap(near.begin(), near.end(), before);
          near.pop_back();
        }
        if (near.size() == count) farthest = std::min(farthest, near.front().square);
      });
  std::sort_heap(near.begin(), near.end(), before);
}

}  // namespace thiessen
