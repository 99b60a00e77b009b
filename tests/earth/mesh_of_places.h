#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "earth/cells/cell_mesh.h"
#include "earth/random_points.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/sphere_tessellation.h"

namespace thiessen {

/// So many places scattered within some metres of a centre, along each of two axes.
inline std::vector<Point> places_round(Seeded& seeded, Point centre, double metres,
                                       std::size_t count) {
  std::vector<Point> places;
  while (places.size() < count)
    places.push_back(
        moved(centre, seeded.uniform(-metres, metres), seeded.uniform(-metres, metres)));
  return places;
}

/// A closed mesh: every side is joined to one that runs the other way between the same places.
inline void expect_closed(const CellMesh& mesh) {
  for (std::uint32_t i = 0; i < mesh.sides(); ++i) {
    const SideIndex s{i};
    const SideIndex beyond = mesh.twin(s);
    EXPECT_NE(beyond, s);
    EXPECT_EQ(mesh.twin(beyond), s);
    EXPECT_EQ(mesh.from(beyond), mesh.to(s));
    EXPECT_EQ(mesh.to(beyond), mesh.from(s));
  }
}

/// The least of the geodesic distances from the places to a point.
inline double nearest_distance(const std::vector<Point>& places, Point p) {
  double least = geodesic_distance(places.front(), p);
  for (const Point place : places) least = std::min(least, geodesic_distance(place, p));
  return least;
}

}  // namespace thiessen
