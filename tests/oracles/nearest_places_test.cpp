// Nearest places against Karney's distances to each, and in the plane against exact ones.
#include "earth/nearest_places.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
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

TEST(NearestPlacesAgainstKarney, all_over_the_earth) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20); ++round) {
    const double size = std::pow(10, seeded.uniform(-4, 2.2));
    const Point centre{seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
    std::vector<Point> places;
    for (int i = 0; i < 80; ++i) {
      places.push_back({std::remainder(centre.x + size * seeded.uniform(-1, 1), 360),
                        std::clamp(centre.y + size * seeded.uniform(-1, 1), -89.99, 89.99)});
    }
    places = distinct(places);
    const auto nearest = nearest_places(places, Metric::geodesic);
    PlaceIndex hint{0};
    std::vector<PlaceIndex> found;
    for (int i = 0; i < 200; ++i) {
      Point p{seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
      if (i % 2 == 0) {
        const Point a = places[seeded.below(places.size())];
        const Point b = places[seeded.below(places.size())];
        p = {(a.x + b.x) / 2, (a.y + b.y) / 2};
      }
      nearest->find(p, hint, found);
      ASSERT_FALSE(found.empty());
      hint = found.front();
      double least = HUGE_VAL;
      for (const Point q : places) least = std::min(least, geodesic_distance(p, q));
      for (const PlaceIndex place : found)
        ASSERT_LE(geodesic_distance(p, places[index(place)]), least + 3e-8) << p.x << " " << p.y;
    }
  }
}

TEST(NearestPlacesAgainstKarney, in_the_plane_are_all_that_are_as_near) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    std::vector<Point> places;
    const std::int64_t side = 1 + seeded.whole(0, 6);
    for (int i = 0; i < 30; ++i)
      places.push_back({static_cast<double>(seeded.whole(-side, side)),
                        static_cast<double>(seeded.whole(-side, side))});
    places = distinct(places);
    const auto nearest = nearest_places(places, Metric::planar);
    std::vector<PlaceIndex> found;
    for (int i = 0; i < 30; ++i) {
      const Point p{static_cast<double>(seeded.whole(-12, 12)) / 2,
                    static_cast<double>(seeded.whole(-12, 12)) / 2};
      nearest->find(p, PlaceIndex{0}, found);
      std::sort(found.begin(), found.end());
      std::vector<PlaceIndex> expected;
      for (std::uint32_t k = 0; k < places.size(); ++k) {
        const bool none_nearer = std::none_of(places.begin(), places.end(), [&](Point q) {
          return compare_distance(p, q, places[k]) < 0;
        });
        if (none_nearer) expected.push_back(PlaceIndex{k});
      }
      ASSERT_EQ(found, expected);
    }
  }
}

}  // namespace
}  // namespace thiessen
