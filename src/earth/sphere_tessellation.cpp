#include "earth/sphere_tessellation.h"

#include <algorithm>

namespace thiessen {
namespace {

std::vector<Direction> directions_of(std::span<const Point> places) {
  std::vector<Direction> directions;
  directions.reserve(places.size());
  for (const Point p : places) directions.push_back(on_sphere(p));
  return directions;
}

PlaceIndex first_of(std::span<const Point> places) {
  return PlaceIndex{
      static_cast<std::uint32_t>(std::min_element(places.begin(), places.end()) - places.begin())};
}

}  // namespace

SphereTessellation::SphereTessellation(std::span<const Point> places)
    : directions_(directions_of(places)),
      pole_(first_of(places)),
      chart_(directions_[index(pole_)]) {
  std::vector<Point> projected;
  for (std::uint32_t i = 0; i < directions_.size(); ++i) {
    const bool is_pole = chart_.is_pole(directions_[i]);
    cell_of_.push_back(is_pole ? pole_ : PlaceIndex{i});
    if (is_pole) continue;
    projected.push_back(chart_.project(directions_[i]));
    place_of_.push_back(PlaceIndex{i});
  }
  const std::vector<PointId> inserted = tessellation_.add_all(projected);
  for (std::size_t i = 0; i < inserted.size(); ++i) {
    cell_of_[index(place_of_[i])] = place_of_[index(inserted[i])];
  }
  connect();
}

void SphereTessellation::connect() {
  neighbours_.resize(directions_.size());
  const auto join = [&](PlaceIndex a, PlaceIndex b) {
    neighbours_[index(a)].push_back(b);
    neighbours_[index(b)].push_back(a);
  };
  if (tessellation_.span() != Span::plane) {
    std::vector<PointId> ring = tessellation_.along_line();
    ring.push_back(infinite_point);
    for (std::size_t i = 0; ring.size() > 1 && i < ring.size(); ++i) {
      join(place(ring[i]), place(ring[(i + 1) % ring.size()]));
    }
  } else {
    const Topology<2>& topology = tessellation_.topology();
    for (std::uint32_t i = 0; i < topology.size(); ++i) {
      for (std::size_t side = 0; side < 3; ++side) {
        if (index(topology.neighbour(VertexId{i}, side)) < i) continue;
        const auto& forming = topology.forming(VertexId{i});
        join(place(forming[(side + 1) % 3]), place(forming[(side + 2) % 3]));
      }
    }
  }
  for (std::uint32_t i = 0; i < cell_of_.size(); ++i) {
    if (index(cell_of_[i]) != i) join(cell_of_[i], PlaceIndex{i});
  }
}

PlaceIndex SphereTessellation::nearest(Direction p, PlaceIndex start) const {
  PlaceIndex best = start;
  double distance = square_distance(p, best);
  for (bool moved = true; moved;) {
    moved = false;
    for (const PlaceIndex q : neighbours_[index(best)]) {
      const double d = square_distance(p, q);
      if (d >= distance) continue;
      best = q;
      distance = d;
      moved = true;
      break;
    }
  }
  return best;
}

PlaceIndex SphereTessellation::nearest(Direction p) const {
  if (chart_.is_pole(p)) return pole_;
  const auto start = tessellation_.nearest(chart_.project(p));
  return nearest(p, start ? place_of_[index(*start)] : pole_);
}

}  // namespace thiessen
