#include "study/gauge_spacing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace thiessen {
namespace {

Ruler on_earth() {
  StudyParts parts;
  parts.metric = Metric::geodesic;
  return Ruler(parts);
}

Ruler in_units() {
  return Ruler(StudyParts());
}

TEST(GaugeSpacing, a_lattice_has_the_spacing_of_its_sides) {
  std::vector<Point> places;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) places.push_back({3.0 * i, 3.0 * j});
  }
  const GaugeSpacing spacing = spacing_of(places, in_units());
  EXPECT_EQ(spacing.median_edge, 3);  // 180 sides and 81 diagonals
  EXPECT_EQ(spacing.to_nearest, std::vector<double>(100, 3.0));
  EXPECT_TRUE(lonely_places(spacing).empty());
}

TEST(GaugeSpacing, one_place_has_none_and_two_have_their_distance) {
  EXPECT_FALSE(spacing_of(std::vector<Point>{{1, 1}}, in_units()).median_edge);
  const GaugeSpacing two = spacing_of(std::vector<Point>{{0, 0}, {3, 4}}, in_units());
  EXPECT_EQ(two.median_edge, 5);
  EXPECT_TRUE(lonely_places(two).empty());
}

TEST(GaugeSpacing, on_the_earth_the_nearest_neighbour_is_by_geodesics) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<Point> places;
  for (int i = 0; i < 200; ++i) places.push_back({175 + 10 * any(random), 60 + 20 * any(random)});
  for (Point& p : places) p.x = p.x > 180 ? p.x - 360 : p.x;
  const Ruler ruler = on_earth();
  const GaugeSpacing spacing = spacing_of(places, ruler);
  for (std::size_t i = 0; i < places.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < places.size(); ++j) {
      if (i != j) least = std::min(least, ruler.distance(places[i], places[j]));
    }
    EXPECT_NEAR(spacing.to_nearest[i], least, 0.005 * least);
  }
}

TEST(GaugeSpacing, a_gauge_with_the_wrong_sign_is_far_from_all_others) {
  const std::vector<Point> places = {
      {-105, 40}, {-105.2, 40.1}, {105.1, 40.3}, {-104.9, 39.8}, {-105.4, 39.9}};
  const auto lonely = lonely_places(spacing_of(places, on_earth()));
  ASSERT_EQ(lonely.size(), 1U);
  EXPECT_EQ(lonely[0].place, PlaceIndex{2});
  EXPECT_GT(lonely[0].distance, 9e6);
}

TEST(GaugeSpacing, a_town_does_not_make_the_country_lonely) {
  std::vector<Point> places;
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 7; ++j) places.push_back({0.01 * i, 0.01 * j});
  }
  for (int i = 0; i < 20; ++i) places.push_back({1.0 + i % 5, 1.0 + i / 5});
  EXPECT_TRUE(lonely_places(spacing_of(places, in_units())).empty());
}

TEST(GaugeSpacing, places_all_round_the_earth) {
  std::vector<Point> places = {{0, 90}, {0, -90}};
  for (int i = 0; i < 8; ++i) places.push_back({45.0 * i - 180, 0});
  const GaugeSpacing spacing = spacing_of(places, on_earth());
  EXPECT_NEAR(spacing.to_nearest[0], 1.0002e7, 1e4);
  EXPECT_NEAR(spacing.to_nearest[2], 5.0e6, 2e4);
}

}  // namespace
}  // namespace thiessen
