#include "study/nearest_gauges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace thiessen {
namespace {

Ruler on_earth() {
  StudyParts parts;
  parts.metric = Metric::geodesic;
  return Ruler(parts);
}

Ruler in_metres() {
  StudyParts parts;
  parts.metres_per_unit = 1;
  return Ruler(parts);
}

Basin box(double west, double south, double east, double north) {
  return {"b", {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}}, {}};
}

/// The least distance from any place to many points of the basin's edges.
double by_sampling(const std::vector<Point>& places, const Basin& basin, const Ruler& ruler) {
  double least = std::numeric_limits<double>::infinity();
  for (const Polygon& polygon : basin.shape) {
    const Ring& ring = polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      for (int k = 0; k < 200; ++k) {
        const Point p{a.x + (b.x - a.x) * k / 200, a.y + (b.y - a.y) * k / 200};
        for (const Point place : places) least = std::min(least, ruler.distance(place, p));
      }
    }
  }
  return least;
}

TEST(NearestGauges, straight_distance_to_an_edge_far_from_its_ends) {
  const std::vector<Point> places = {{500, -30}, {2000, 0}, {0, 1000}};
  const auto nearest = nearest_gauges(places, std::vector{box(0, 0, 1000, 100)}, in_metres());
  EXPECT_EQ(nearest[0].place, PlaceIndex{0});
  EXPECT_NEAR(nearest[0].distance, 30, 0.3);
}

TEST(NearestGauges, a_gauge_on_the_outline_is_at_no_distance) {
  const auto nearest = nearest_gauges(std::vector<Point>{{7, 7}, {0, 50}},
                                      std::vector{box(0, 0, 100, 100)}, in_metres());
  EXPECT_NEAR(nearest[0].distance, 0, 1e-9);
}

TEST(NearestGauges, the_antimeridian_is_no_border) {
  const auto nearest = nearest_gauges(std::vector<Point>{{-179, 10}, {170, 10}},
                                      std::vector{box(178, 9, 179.5, 11)}, on_earth());
  EXPECT_EQ(nearest[0].place, PlaceIndex{0});
  EXPECT_NEAR(nearest[0].distance, on_earth().distance({-179, 10}, {179.5, 10}), 1700);
}

TEST(NearestGauges, law_it_is_the_least_distance_to_a_hundredth) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0, 1);
  for (const Ruler& ruler : {on_earth(), in_metres()}) {
    for (int round = 0; round < 40; ++round) {
      const double size = std::pow(10.0, -2 + 3 * any(random));
      std::vector<Point> places;
      for (int i = 0; i < 30; ++i)
        places.push_back({20 + 4 * size * any(random), 4 * size * any(random)});
      const double x = 20 + 6 * size * any(random);
      const double y = 6 * size * any(random);
      const Basin basin = box(x, y, x + size, y + size * any(random) + 1e-3);
      const double found = nearest_gauges(places, std::vector{basin}, ruler)[0].distance;
      const double least = by_sampling(places, basin, ruler);
      EXPECT_LE(found, 1.01 * least + 1e-6) << "size " << size;
      // Samples miss the nearest point by up to half the way between two of them.
      EXPECT_GE(found, least - ruler.distance({x, y}, {x + size / 200, y})) << "size " << size;
    }
  }
}

TEST(NearestGauges, law_a_place_that_is_near_enough_ends_the_walk_and_is_near_enough) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> any(0, 1);
  for (const Ruler& ruler : {on_earth(), in_metres()}) {
    for (int round = 0; round < 100; ++round) {
      std::vector<Point> places;
      for (int i = 0; i < 30; ++i) places.push_back({20 + 40 * any(random), 40 * any(random)});
      const Point corner{20 + 80 * any(random), 60 * any(random)};
      const std::vector basins{box(corner.x, corner.y, corner.x + 9, corner.y + 5)};
      const NearestGauge exact = nearest_gauges(places, basins, ruler)[0];
      for (const double share : {0.5, 0.99, 1.5, 3.0}) {
        const std::vector<double> enough{share * exact.distance};
        const NearestGauge found = nearest_gauges(places, basins, ruler, enough)[0];
        if (share < 1) {
          EXPECT_EQ(found.distance, exact.distance);
          EXPECT_EQ(found.place, exact.place);
        } else {
          EXPECT_LE(found.distance, std::max(enough[0], exact.distance));
        }
      }
    }
  }
}

}  // namespace
}  // namespace thiessen
