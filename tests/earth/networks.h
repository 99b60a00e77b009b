#pragma once

#include <vector>

#include "earth/random_points.h"

namespace thiessen {

/// Places that are hard on a tessellation of the Earth.
struct WorldNetwork {
  const char* name;
  std::vector<Point> places;
};

inline std::vector<WorldNetwork> world_networks(Seeded& seeded) {
  std::vector<Point> world, town, antimeridian, graticule, parallel, poles{{0, 90}, {0, -90}};
  for (int i = 0; i < 150; ++i) world.push_back(random_point(seeded));
  for (int i = 0; i < 60; ++i) {
    town.push_back(moved({10, 47}, seeded.uniform(-5e3, 5e3), seeded.uniform(-5e3, 5e3)));
    const double longitude = seeded.uniform(175, 185);
    antimeridian.push_back({longitude > 180 ? longitude - 360 : longitude, seeded.uniform(-5, 5)});
    parallel.push_back({6.0 * i, 40});
    poles.push_back({seeded.uniform(-180, 180), seeded.uniform(80, 90) * (i % 2 == 0 ? 1 : -1)});
  }
  for (int i = 0; i < 12; ++i) {
    for (int k = -5; k <= 5; ++k) graticule.push_back({30.0 * i - 180, 15.0 * k});
  }
  return {{"world", world},         {"town", town},         {"antimeridian", antimeridian},
          {"graticule", graticule}, {"parallel", parallel}, {"poles", poles}};
}

}  // namespace thiessen
