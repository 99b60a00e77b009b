#include "rainfall/errors/sites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

std::vector<Point> scattered(Seeded& seeded, std::size_t count, bool lattice) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(lattice ? Point{static_cast<double>(i % 17), static_cast<double>(i / 17)}
                             : Point{seeded.uniform(-10, 30), seeded.uniform(40, 60)});
  }
  return points;
}

TEST(Sites, are_numbered_by_their_positions_alone) {
  Seeded seeded;
  for (const Metric metric : {Metric::planar, Metric::geodesic}) {
    std::vector<Point> points = scattered(seeded, 300, false);
    const Sites sites(points, metric);
    std::vector<Point> shuffled = points;
    std::shuffle(shuffled.begin(), shuffled.end(), seeded.generator());
    const Sites again(shuffled, metric);
    for (std::uint32_t s = 0; s < sites.size(); ++s) {
      EXPECT_EQ(points[sites.place_of(s)], shuffled[again.place_of(s)]);
      EXPECT_EQ(sites.of_place(sites.place_of(s)), s);
    }
  }
}

// Law: the others in the order of their distances, and of their numbers where these are equal.
TEST(Sites, know_their_nearest_others) {
  Seeded seeded;
  for (const bool lattice : {false, true}) {
    for (const std::size_t count : {1u, 2u, 9u, 13u, 14u, 400u}) {
      const Sites sites(scattered(seeded, count, lattice),
                        lattice ? Metric::planar : Metric::geodesic);
      const auto found = sites.nearest_others(12);
      for (std::uint32_t s = 0; s < sites.size(); ++s) {
        std::vector<std::pair<double, std::uint32_t>> others;
        for (std::uint32_t o = 0; o < sites.size(); ++o) {
          if (o != s) others.emplace_back(square_distance(sites[s], sites[o]), o);
        }
        std::sort(others.begin(), others.end());
        ASSERT_EQ(found[s].size(), std::min<std::size_t>(12, others.size()));
        for (std::size_t k = 0; k < found[s].size(); ++k) ASSERT_EQ(found[s][k], others[k].second);
      }
    }
  }
}

}  // namespace
}  // namespace thiessen
