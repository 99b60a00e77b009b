#include "study/nearest_gauges.h"

#include <algorithm>
#include <limits>

namespace thiessen {
namespace {

/// The least step of the walk, as a share of the distance from the gauges.
constexpr double least_step = 0.02;

PlaceTree tree_of(std::span<const Point> places, const Ruler& ruler) {
  std::vector<Direction> there;
  there.reserve(places.size());
  for (const Point p : places) there.push_back(ruler.in_space(p));
  return PlaceTree(std::move(there));
}

/// A walk along the outline of a basin in search of the nearest place.
class Walk {
 public:
  /// A walk that ends at a place whose distance by the ruler is no more than `enough`. No geodesic
  /// is 1.6 times as long as its chord.
  Walk(const PlaceTree& tree, const Ruler& ruler, double enough)
      : tree_(tree), ruler_(ruler), enough_(enough / 1.6) {}

  void along(const Basin& basin) {
    for (const Polygon& polygon : basin.shape) {
      along(polygon.outer);
      for (const Ring& hole : polygon.holes) along(hole);
    }
  }
  PlaceIndex place() const { return best_; }
  Point nearest_point() const { return from_; }

 private:
  void along(const Ring& ring) {
    free_ = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      along(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  }

  void along(Point a, Point b) {
    const double length = ruler_.longest(a, b);
    double walked = free_;
    while (walked <= length && distance_ > enough_) {
      const double share = length > 0 ? walked / length : 0;
      const double step = look_from({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
      if (!(walked + step > walked)) break;
      walked += step;
    }
    free_ = std::max(walked - length, 0.0);
  }

  /// Looks for the place that is nearest to a point of the outline, and returns how far one may go
  /// on from there before anything nearer than the best can come.
  double look_from(Point p) {
    const Direction at = ruler_.in_space(p);
    const PlaceIndex place = tree_.nearest(at, last_);
    last_ = place;
    const double there = length(tree_[place] - at);
    if (there < distance_) {
      distance_ = there;
      best_ = place;
      from_ = p;
    }
    return std::max(there - distance_, least_step * there);
  }

  const PlaceTree& tree_;
  const Ruler& ruler_;
  double enough_;
  double distance_ = std::numeric_limits<double>::infinity();
  double free_ = 0;  // how far the walk may go on without looking
  PlaceIndex best_{0};
  PlaceIndex last_{0};  // the nearest where the walk looked last
  Point from_;
};

}  // namespace

std::vector<NearestGauge> nearest_gauges(std::span<const Point> places,
                                         std::span<const Basin> basins, const Ruler& ruler,
                                         std::span<const double> enough) {
  const PlaceTree tree = tree_of(places, ruler);
  std::vector<NearestGauge> nearest;
  nearest.reserve(basins.size());
  for (std::size_t b = 0; b < basins.size(); ++b) {
    Walk walk(tree, ruler, enough.empty() ? 0 : enough[b]);
    walk.along(basins[b]);
    const Point place = places[index(walk.place())];
    nearest.push_back({walk.place(), ruler.distance(place, walk.nearest_point())});
  }
  return nearest;
}

}  // namespace thiessen
