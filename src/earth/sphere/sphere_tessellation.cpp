#include "earth/sphere/sphere_tessellation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/geodesic.h"
#include "geometry/disjoint_sets.h"

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
    : positions_(places.begin(), places.end()),
      directions_(directions_of(places)),
      pole_(first_of(places)),
      chart_(directions_[index(pole_)]) {
  for (std::uint32_t i = 0; i < places.size(); ++i) cell_of_.push_back(PlaceIndex{i});
  tessellate();
  if (merge_indistinct()) tessellate();
}

// Tessellates the places that have a cell of their own.
void SphereTessellation::tessellate() {
  std::vector<Point> projected;
  std::vector<PlaceIndex> places;
  for (std::uint32_t i = 0; i < directions_.size(); ++i) {
    if (index(cell_of_[i]) != i) continue;
    if (chart_.is_pole(directions_[i])) {
      cell_of_[i] = pole_;
      continue;
    }
    projected.push_back(chart_.project(directions_[i]));
    places.push_back(PlaceIndex{i});
  }
  tessellation_ = {};
  const std::vector<PointId> points = tessellation_.add_all(projected);
  place_of_.assign(tessellation_.topology().point_limit(), pole_);
  for (std::size_t i = 0; i < points.size(); ++i) {
    PlaceIndex& place = place_of_[index(points[i])];
    if (place == pole_ || positions_[index(places[i])] < positions_[index(place)])
      place = places[i];
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    cell_of_[index(places[i])] = place_of_[index(points[i])];
}

// Each place's nearest one is a Delaunay neighbour, so places that are too near each other are
// found along Delaunay edges.
bool SphereTessellation::merge_indistinct() {
  constexpr double indistinct = 1e-13;
  bool merged = false;
  DisjointSets cells(cell_of_.size());
  for (std::size_t i = 0; i < cell_of_.size(); ++i) {
    cells.unite(cells.find(index(cell_of_[i])), cells.find(i));
  }
  for_each_edge([&](PlaceIndex a, PlaceIndex b) {
    const Direction chord = directions_[index(b)] - directions_[index(a)];
    if (dot(chord, chord) > indistinct * indistinct) return;
    const std::uint32_t first = cells.find(index(a));
    const std::uint32_t second = cells.find(index(b));
    if (first == second) return;
    const bool keeps_first = positions_[first] < positions_[second];
    cells.unite(keeps_first ? first : second, keeps_first ? second : first);
    merged = true;
  });
  for (std::size_t i = 0; i < cell_of_.size(); ++i) cell_of_[i] = PlaceIndex{cells.find(i)};
  return merged;
}

// Visits the pairs of places whose cells have an edge in common, and of those that share a cell.
template <typename Visit>
void SphereTessellation::for_each_link(Visit&& visit) const {
  for_each_edge(visit);
  for (std::uint32_t i = 0; i < cell_of_.size(); ++i) {
    if (index(cell_of_[i]) != i) visit(cell_of_[i], PlaceIndex{i});
  }
}

void SphereTessellation::connect() const {
  first_neighbour_.assign(directions_.size() + 1, 0);
  for_each_link([&](PlaceIndex a, PlaceIndex b) {
    ++first_neighbour_[index(a) + 1];
    ++first_neighbour_[index(b) + 1];
  });
  std::partial_sum(first_neighbour_.begin(), first_neighbour_.end(), first_neighbour_.begin());
  neighbours_.resize(first_neighbour_.back());
  std::vector<std::uint32_t> next(first_neighbour_.begin(), first_neighbour_.end() - 1);
  for_each_link([&](PlaceIndex a, PlaceIndex b) {
    neighbours_[next[index(a)]++] = b;
    neighbours_[next[index(b)]++] = a;
  });
}

Direction SphereTessellation::chord(PlaceIndex a, PlaceIndex b, double turned) const {
  const Direction difference = direction(b) - direction(a);
  const double shortest = 1e-16 / turned;
  return dot(difference, difference) > shortest * shortest
             ? difference
             : chord_on_sphere(positions_[index(a)], positions_[index(b)]);
}

std::uint8_t SphereTessellation::first_corner(const std::array<PlaceIndex, 3>& corners) const {
  const auto first = std::min_element(
      corners.begin(), corners.end(),
      [&](PlaceIndex a, PlaceIndex b) { return positions_[index(a)] < positions_[index(b)]; });
  return static_cast<std::uint8_t>(first - corners.begin());
}

std::array<PlaceIndex, 3> SphereTessellation::in_order(std::array<PlaceIndex, 3> corners) const {
  std::rotate(corners.begin(), corners.begin() + first_corner(corners), corners.end());
  return corners;
}

std::array<Point, 3> SphereTessellation::key_of(const std::array<PlaceIndex, 3>& corners) const {
  std::array<Point, 3> key{positions_[index(corners[0])], positions_[index(corners[1])],
                           positions_[index(corners[2])]};
  std::sort(key.begin(), key.end());
  return key;
}

PlaceIndex SphereTessellation::nearest(Direction p, PlaceIndex start) const {
  PlaceIndex best = start;
  double distance = square_distance(p, best);
  for (bool moved = true; moved;) {
    moved = false;
    for (const PlaceIndex q : neighbours(best)) {
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

// The conformal sphere's scale varies by 0.34 %, so the nearest place on the Earth is no more than
// that farther than the nearest on the sphere, and a chain of neighbours no farther away leads to
// it.
PlaceIndex SphereTessellation::nearest_on_earth(Point p) const {
  const Direction direction = on_sphere(p);
  std::vector<PlaceIndex> near{nearest(direction)};
  const double reach = square_distance(direction, near.front()) * scale_variation * scale_variation;
  for (std::size_t next = 0; next < near.size(); ++next) {
    for (const PlaceIndex q : neighbours(near[next])) {
      if (square_distance(direction, q) > reach) continue;
      if (std::find(near.begin(), near.end(), q) == near.end()) near.push_back(q);
    }
  }
  PlaceIndex best = near.front();
  double least = HUGE_VAL;
  for (std::size_t i = 0; near.size() > 1 && i < near.size(); ++i) {
    const double distance = geodesic_distance(positions_[index(near[i])], p);
    if (distance >= least) continue;
    best = near[i];
    least = distance;
  }
  return best;
}

PlaceIndex SphereTessellation::nearest(Direction p) const {
  if (chart_.is_pole(p)) return pole_;
  const auto start = tessellation_.nearest(chart_.project(p));
  return nearest(p, start ? place_of_[index(*start)] : pole_);
}

}  // namespace thiessen
