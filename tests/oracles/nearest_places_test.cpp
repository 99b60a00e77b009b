// Compiled alone: the headers of other oracles hold another geodesic_distance.
// Rivals and nearest places against Karney's distances to each, and in the plane against exact
// ones.
#include "earth/nearest/nearest_places.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "geometry/predicates.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

double geodesic_distance(Point a, Point b) {
  double metres = 0;
  GeographicLib::Geodesic::WGS84().Inverse(a.y, a.x, b.y, b.x, metres);
  return metres;
}

std::vector<Point> distinct(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<Point> places_round(Seeded& seeded, Point centre, double size) {
  std::vector<Point> places;
  for (int i = 0; i < 80; ++i) {
    places.push_back({std::remainder(centre.x + size * seeded.uniform(-1, 1), 360),
                      std::clamp(centre.y + size * seeded.uniform(-1, 1), -89.99, 89.99)});
  }
  return distinct(places);
}

bool holds(const std::vector<PlaceIndex>& places, std::size_t place) {
  return std::find(places.begin(), places.end(), PlaceIndex{static_cast<std::uint32_t>(place)}) !=
         places.end();
}

// For points of a ball the nearest is among the ball's rivals, and those of a ball within it.
TEST(NearestPlacesAgainstKarney, are_among_the_rivals_all_over_the_earth) {
  Seeded seeded;
  std::size_t rivals_found = 0;
  std::size_t balls = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(25); ++round) {
    const double size = std::pow(10, seeded.uniform(-4, 2.2));
    const Point centre{seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
    const std::vector<Point> places = places_round(seeded, centre, size);
    const auto nearest = nearest_places(places, Metric::geodesic);
    for (int i = 0; i < 60; ++i) {
      Point middle{seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
      if (i % 3 == 0) middle = {centre.x + 180 + seeded.uniform(-2, 2), -centre.y};
      if (i % 3 == 1) middle = {centre.x + 2 * size * seeded.uniform(-1, 1), centre.y};
      const double spread = std::pow(10, seeded.uniform(-6, 1));
      const auto in_ball = [&](double share) {
        return Point{middle.x + share * spread * seeded.uniform(-1, 1),
                     std::clamp(middle.y + share * spread * seeded.uniform(-1, 1), -90.0, 90.0)};
      };
      std::vector<Point> points;
      for (int k = 0; k < 10; ++k) points.push_back(in_ball(k < 5 ? 0.1 : 1));
      Ball ball{nearest->in_space(points.front()), 0};
      Ball inner = ball;
      for (int k = 0; k < 10; ++k) {
        const double way =
            length(nearest->in_space(points[static_cast<std::size_t>(k)]) - ball.centre);
        ball.radius = std::max(ball.radius, way);
        if (k < 5) inner.radius = ball.radius;
      }
      std::vector<PlaceIndex> rivals;
      std::vector<PlaceIndex> inner_rivals;
      nearest->find_rivals(ball, rivals);
      nearest->keep_rivals(inner, rivals, inner_rivals);
      rivals_found += rivals.size();
      ++balls;
      for (int k = 0; k < 10; ++k) {
        const Point p = points[static_cast<std::size_t>(k)];
        std::vector<double> distances;
        for (const Point q : places) distances.push_back(geodesic_distance(p, q));
        const double least = *std::min_element(distances.begin(), distances.end());
        for (std::size_t q = 0; q < places.size(); ++q) {
          if (distances[q] > least + 1e-7) continue;
          ASSERT_TRUE(holds(rivals, q)) << p.x << " " << p.y;
          ASSERT_TRUE(k >= 5 || holds(inner_rivals, q)) << p.x << " " << p.y;
        }
        const auto found = nearest->nearest(p, k < 5 ? inner_rivals : rivals);
        ASSERT_TRUE(found);
        ASSERT_LE(distances[index(*found)], least + 8e-8) << p.x << " " << p.y;
      }
    }
  }
  // Finding all to be rivals would be right, but no help.
  EXPECT_LT(rivals_found, 30 * balls);
}

TEST(NearestPlacesAgainstKarney, none_is_nearest_to_what_is_not_on_the_earth) {
  const auto nearest = nearest_places(std::vector<Point>{{0, 0}, {1, 1}}, Metric::geodesic);
  const std::vector<PlaceIndex> both{PlaceIndex{0}, PlaceIndex{1}};
  EXPECT_FALSE(nearest->nearest({0, 90.5}, both));
  EXPECT_FALSE(nearest->nearest({0, std::nan("")}, both));
  EXPECT_TRUE(nearest->nearest({720, -90}, both));
}

TEST(NearestPlacesAgainstKarney, in_the_plane_are_the_first_of_those_as_near) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    std::vector<Point> places;
    const std::int64_t side = 1 + seeded.whole(0, 6);
    for (int i = 0; i < 30; ++i)
      places.push_back({static_cast<double>(seeded.whole(-side, side)),
                        static_cast<double>(seeded.whole(-side, side))});
    places = distinct(places);
    const auto nearest = nearest_places(places, Metric::planar);
    std::vector<PlaceIndex> rivals;
    for (int i = 0; i < 30; ++i) {
      const Point p{static_cast<double>(seeded.whole(-12, 12)) / 2,
                    static_cast<double>(seeded.whole(-12, 12)) / 2};
      nearest->find_rivals({nearest->in_space(p), 1e-12}, rivals);
      std::vector<PlaceIndex> expected;
      for (std::uint32_t k = 0; k < places.size(); ++k) {
        const bool none_nearer = std::none_of(places.begin(), places.end(), [&](Point q) {
          return compare_distance(p, q, places[k]) < 0;
        });
        if (none_nearer) expected.push_back(PlaceIndex{k});
      }
      ASSERT_EQ(rivals, expected);
      ASSERT_EQ(nearest->nearest(p, rivals), expected.front());
    }
  }
}

}  // namespace
}  // namespace thiessen
