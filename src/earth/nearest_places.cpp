#include "earth/nearest_places.h"

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <utility>

#include "earth/sphere_tessellation.h"

namespace thiessen {
namespace {

class NearestInPlane : public NearestPlaces {
 public:
  explicit NearestInPlane(std::span<const Point> places)
      : points_(tessellation_.add_all(places)), place_of_(tessellation_.topology().point_limit()) {
    for (std::uint32_t i = 0; i < points_.size(); ++i) place_of_[index(points_[i])] = PlaceIndex{i};
  }

  void find(Point p, PlaceIndex hint, std::vector<PlaceIndex>& nearest) const override {
    std::vector<PointId> points;
    tessellation_.find_nearest(p, points_[index(hint)], points);
    nearest.clear();
    for (const PointId point : points) nearest.push_back(place_of_[index(point)]);
  }

 private:
  Tessellation<2> tessellation_;
  std::vector<PointId> points_;       // by place
  std::vector<PlaceIndex> place_of_;  // by point
};

class NearestOnEarth : public NearestPlaces {
 public:
  explicit NearestOnEarth(std::span<const Point> places)
      : places_(places.begin(), places.end()), sphere_(places) {}

  // The conformal sphere's scale varies by 0.34 %: what is nearest on the Earth is no more than
  // that farther than the nearest on the sphere, and hangs together with it by places no farther
  // away.
  void find(Point p, PlaceIndex hint, std::vector<PlaceIndex>& nearest) const override {
    const Direction direction = on_sphere(p);
    const PlaceIndex first = sphere_.nearest(direction, hint);
    constexpr double scale_variation = 1.004;
    const double reach =
        sphere_.square_distance(direction, first) * scale_variation * scale_variation;
    nearest.assign(1, first);
    for (std::size_t next = 0; next < nearest.size(); ++next) {
      for (const PlaceIndex q : sphere_.neighbours(nearest[next])) {
        if (sphere_.square_distance(direction, q) > reach) continue;
        if (std::find(nearest.begin(), nearest.end(), q) == nearest.end()) nearest.push_back(q);
      }
    }
    if (nearest.size() > 1) keep_nearest_on_earth(p, nearest);
  }

 private:
  void keep_nearest_on_earth(Point p, std::vector<PlaceIndex>& nearest) const {
    const GeographicLib::Geodesic& earth = GeographicLib::Geodesic::WGS84();
    std::vector<std::pair<double, PlaceIndex>> by_distance;
    for (const PlaceIndex q : nearest) {
      const Point place = places_[index(q)];
      double distance = 0;
      earth.Inverse(p.y, p.x, place.y, place.x, distance);
      by_distance.emplace_back(distance, q);
    }
    const double least = std::min_element(by_distance.begin(), by_distance.end())->first;
    nearest.clear();
    for (const auto& [distance, q] : by_distance) {
      if (distance == least) nearest.push_back(q);
    }
  }

  std::vector<Point> places_;
  SphereTessellation sphere_;
};

}  // namespace

std::unique_ptr<NearestPlaces> nearest_places(std::span<const Point> places, Metric metric) {
  if (metric == Metric::planar) return std::make_unique<NearestInPlane>(places);
  return std::make_unique<NearestOnEarth>(places);
}

}  // namespace thiessen
