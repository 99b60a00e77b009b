#include "earth/nearest_places.h"

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
  explicit NearestOnEarth(std::span<const Point> places) : sphere_(places) {}

  void find(Point p, PlaceIndex hint, std::vector<PlaceIndex>& nearest) const override {
    sphere_.find_nearest_on_earth(p, hint, nearest);
  }

 private:
  SphereTessellation sphere_;
};

}  // namespace

std::unique_ptr<NearestPlaces> nearest_places(std::span<const Point> places, Metric metric) {
  if (metric == Metric::planar) return std::make_unique<NearestInPlane>(places);
  return std::make_unique<NearestOnEarth>(places);
}

}  // namespace thiessen
