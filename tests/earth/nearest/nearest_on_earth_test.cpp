// The nearest places by geodesics, and how few rivals are left where chords alone do not tell.
#include "earth/nearest/nearest_on_earth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "earth/random_points.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

const std::vector<PlaceIndex> both{PlaceIndex{0}, PlaceIndex{1}};

TEST(NearestOnEarth, law_1_it_is_the_one_with_the_shortest_geodesic) {
  Seeded seeded;
  std::vector<Point> places;
  std::vector<PlaceIndex> all;
  for (std::uint32_t i = 0; i < 100; ++i) {
    places.push_back(random_point(seeded));
    all.push_back(PlaceIndex{i});
  }
  const NearestOnEarth nearest(places);
  for (std::uint64_t round = 0; round < Seeded::rounds(100); ++round) {
    const Point p = random_point(seeded);
    const auto found = nearest.nearest(p, all);
    ASSERT_TRUE(found);
    double least = HUGE_VAL;
    for (const Point place : places) least = std::min(least, geodesic_distance(place, p));
    EXPECT_LE(geodesic_distance(places[index(*found)], p), least + 5e-8);
    std::shuffle(all.begin(), all.end(), seeded.generator());
    EXPECT_EQ(nearest.nearest(p, all), found);
  }
}

// Mirrored by the equator, or by a meridian.
TEST(NearestOnEarth, law_2_of_equally_near_ones_it_is_the_first_by_number) {
  const std::vector<PlaceIndex> backward{PlaceIndex{1}, PlaceIndex{0}};
  Seeded seeded;
  for (int i = 0; i < 200; ++i) {
    const Point a{seeded.uniform(-180, 180), seeded.uniform(1, 80)};
    const NearestOnEarth over_equator(std::vector<Point>{{a.x, -a.y}, a});
    EXPECT_EQ(over_equator.nearest({seeded.uniform(-180, 180), 0}, backward), PlaceIndex{0});
    const NearestOnEarth over_meridian(std::vector<Point>{{30 + a.y, 10}, {30 - a.y, 10}});
    EXPECT_EQ(over_meridian.nearest({30, seeded.uniform(-90, 90)}, backward), PlaceIndex{0});
    // A centimetre to the other side is told.
    EXPECT_EQ(over_equator.nearest({a.x, 1e-7}, both), PlaceIndex{1});
  }
}

TEST(NearestOnEarth, law_3_longitudes_go_round_and_latitudes_end_at_the_poles) {
  const NearestOnEarth nearest(std::vector<Point>{{179, 10}, {-170, 10}});
  EXPECT_EQ(nearest.nearest({-179, 10}, both), PlaceIndex{0});
  EXPECT_EQ(nearest.nearest({181 + 720, 10}, both), PlaceIndex{0});
  EXPECT_EQ(nearest.nearest({186, 10}, both), PlaceIndex{1});
  EXPECT_TRUE(nearest.nearest({0, 90}, both));
  for (const double latitude : {90.000001, -91.0, HUGE_VAL, std::nan("")})
    EXPECT_FALSE(nearest.nearest({0, latitude}, both)) << latitude;
}

// Seen from 2,000 km chords tell 30 metres only if the places are next to each other; seen in
// different directions they do not tell two kilometres. Geodesics do.
TEST(NearestOnEarth, law_4_where_chords_do_not_tell_geodesics_leave_one_rival) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(100); ++round) {
    const Point p{seeded.uniform(-180, 180), seeded.uniform(-80, 80)};
    const std::vector<Point> places{random_point_at(seeded, p, 2e6),
                                    random_point_at(seeded, p, 2e6 + 50)};
    const NearestOnEarth nearest(places);
    const Direction first = nearest.in_space(places[0]);
    const Direction second = nearest.in_space(places[1]);
    std::vector<PlaceIndex> rivals;
    nearest.find_rivals({nearest.in_space(p), 1}, rivals);
    // The difference of the chords' squares changes by twice the distance of the places a metre.
    // Where it may be none in the ball, it is left to smaller balls.
    const double difference =
        dot(second - first, (first - nearest.in_space(p)) + (second - nearest.in_space(p)));
    if (std::abs(difference) > 3 * length(second - first)) {
      EXPECT_EQ(rivals, std::vector<PlaceIndex>{PlaceIndex{0}});
    }
    nearest.find_rivals({nearest.in_space(p), 100}, rivals);
    if (geodesic_distance(places[0], places[1]) > 2e6) {
      EXPECT_EQ(rivals, both);
    }
  }
}

}  // namespace
}  // namespace thiessen
