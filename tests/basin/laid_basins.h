#pragma once

#include <vector>

#include "basin/shapes.h"

namespace thiessen::shapes {

/// A basin over the cells of places; `along`: whether its edges run along the cells'.
struct Laid {
  std::vector<Point> places;
  Basin basin;
  bool along = false;
};

/// The middles of the cells of a square lattice with unit steps.
inline std::vector<Point> lattice(int side) {
  std::vector<Point> places;
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) places.push_back({i + 0.5, k + 0.5});
  }
  return places;
}

inline std::vector<Laid> laid_in_many_ways() {
  Seeded seeded;
  std::vector<Laid> all;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    std::vector<Point> places(2 + seeded.below(60));
    for (Point& p : places) p = {seeded.uniform(0, 8), seeded.uniform(0, 8)};
    const Point centre{seeded.uniform(2, 6), seeded.uniform(2, 6)};
    all.push_back({places, basin({{star(seeded, centre, 3, 20), {}}})});
    all.push_back({places, basin(islands(seeded, {1, 1}, 1.7, 3))});
    all.push_back({places, basin({{snowflake(centre, 2, 3), {}}})});
    all.push_back({places, basin({{comb({1, 2}, 5, 4, 9), {}}})});
    all.push_back({lattice(8), basin({{staircase(seeded, {1, 1}, 1, 6, 6), {}}}), true});
  }
  return all;
}

}  // namespace thiessen::shapes
