#include "study/ruler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace thiessen {
namespace {

// WGS 84: a degree of the equator is an arc of a circle, and a quarter of a meridian is
// 10,001,965.729 metres long (Karney 2011, table 1; also the kilometre's first definition, but for
// 2 km).
constexpr double equator = 6378137;
constexpr double equatorial_degree = equator * std::numbers::pi / 180;
constexpr double quarter_meridian = 10001965.729;

Ruler ruler_of_the_earth() {
  StudyParts parts;
  parts.metric = Metric::geodesic;
  return Ruler(parts);
}

Ruler ruler_of_degrees(double degrees_per_unit) {
  StudyParts parts;
  parts.degrees_per_unit = degrees_per_unit;
  return Ruler(parts);
}

Ruler ruler_of_plane(std::optional<double> metres_per_unit) {
  StudyParts parts;
  parts.metres_per_unit = metres_per_unit;
  return Ruler(parts);
}

TEST(Ruler, knows_what_it_measures_with) {
  EXPECT_TRUE(ruler_of_the_earth().on_earth());
  EXPECT_TRUE(ruler_of_the_earth().knows_metres());
  EXPECT_TRUE(ruler_of_degrees(0.9).on_earth());
  EXPECT_FALSE(ruler_of_plane(1).on_earth());
  EXPECT_TRUE(ruler_of_plane(1).knows_metres());
  EXPECT_FALSE(ruler_of_plane(std::nullopt).knows_metres());
}

TEST(Ruler, is_straight_in_a_plane) {
  EXPECT_EQ(ruler_of_plane(std::nullopt).distance({1, 1}, {4, 5}), 5);
  const Ruler feet = ruler_of_plane(0.3048);
  EXPECT_NEAR(feet.distance({0, 0}, {3000, -4000}), 1524, 1e-9);
  EXPECT_NEAR(feet.longest({0, 0}, {3000, -4000}), 1524, 1e-9);
  const Direction there = feet.in_space({1000, -2000});
  EXPECT_NEAR(there.x, 304.8, 1e-9);
  EXPECT_NEAR(there.y, -609.6, 1e-9);
  EXPECT_EQ(there.z, 0);
}

TEST(Ruler, takes_the_shortest_path_on_the_earth) {
  const Ruler earth = ruler_of_the_earth();
  EXPECT_NEAR(earth.distance({179, 0}, {-178, 0}), 3 * equatorial_degree, 1e-6);
  EXPECT_NEAR(earth.distance({30, 0}, {-70, 90}), quarter_meridian, 1e-3);
  const Direction pole = earth.in_space({0, 90});
  EXPECT_NEAR(pole.z, 6356752.314245, 1e-6);
  // A hundred grads are a right angle.
  const Ruler grads = ruler_of_degrees(0.9);
  EXPECT_NEAR(grads.distance({0, 0}, {100, 0}), 90 * equatorial_degree, 1e-6);
  EXPECT_NEAR(grads.in_space({100, 0}).y, equator, 1e-6);
}

TEST(Ruler, a_latitude_is_at_most_a_right_angle_in_the_coordinates_own_unit) {
  EXPECT_TRUE(ruler_of_the_earth().can_be_latitude(-90));
  EXPECT_FALSE(ruler_of_the_earth().can_be_latitude(90.001));
  EXPECT_TRUE(ruler_of_degrees(0.9).can_be_latitude(100));
  EXPECT_FALSE(ruler_of_degrees(0.9).can_be_latitude(-100.001));
}

/// The length in space of an edge that is straight in the coordinates, as a sum of many chords.
double length_in_space(const Ruler& ruler, Point a, Point b) {
  constexpr int chords = 1000;
  double sum = 0;
  Direction before = ruler.in_space(a);
  for (int i = 1; i <= chords; ++i) {
    const double share = static_cast<double>(i) / chords;
    const Direction at = ruler.in_space({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    sum += std::hypot(at.x - before.x, at.y - before.y, at.z - before.z);
    before = at;
  }
  return sum;
}

TEST(Ruler, law_1_no_edge_is_longer_than_its_bound) {
  const Ruler earth = ruler_of_the_earth();
  for (const double latitude : {-89.0, -45.0, -5.0, 0.0, 30.0, 60.0, 80.0, 89.5}) {
    for (const Point by : std::vector<Point>{{10, 0}, {0, 0.5}, {3, -0.4}, {100, 0.5}, {-7, 10}}) {
      const Point a{15, latitude};
      const Point b{15 + by.x, std::min(latitude + by.y, 90.0)};
      EXPECT_GE(earth.longest(a, b), length_in_space(earth, a, b) * (1 - 1e-9))
          << latitude << " " << by.x << " " << by.y;
    }
  }
}

// What it exceeds a short edge by is most where the meridian's radius is least, at the equator:
// (a / b)^3 = 1.0101.
TEST(Ruler, law_2_the_bound_on_a_short_edge_is_at_most_1_02_percent_too_long) {
  const Ruler earth = ruler_of_the_earth();
  for (const double latitude : {-60.0, 0.0, 45.0, 80.0}) {
    for (const Point by : std::vector<Point>{{0.001, 0}, {0, 0.001}, {0.001, 0.001}}) {
      const Point a{15, latitude};
      const Point b{15 + by.x, latitude + by.y};
      EXPECT_LE(earth.longest(a, b), length_in_space(earth, a, b) * 1.0102) << latitude;
    }
  }
}

void expect_box(const Box& box, Point low, Point high) {
  EXPECT_EQ(box.low, low);
  EXPECT_EQ(box.high, high);
}

TEST(Ruler, an_extent_goes_the_shorter_way_round) {
  const std::vector<Point> pacific{{-170, 10}, {175, -20}, {-178, 0}};
  expect_box(ruler_of_the_earth().extent(pacific), {175, -20}, {190, 10});
  expect_box(ruler_of_plane(1).extent(pacific), {-178, -20}, {175, 10});
  const std::vector<Point> round_the_world{{130, 0}, {-60, 0}, {25, 0}, {-170, 0}};
  expect_box(ruler_of_the_earth().extent(round_the_world), {-60, 0}, {190, 0});
  const std::vector<Point> in_grads{{-190, 0}, {190, 0}};
  expect_box(ruler_of_degrees(0.9).extent(in_grads), {190, 0}, {210, 0});
  EXPECT_TRUE(ruler_of_the_earth().extent({}).empty());
}

TEST(Ruler, a_diagonal_is_at_most_half_way_round_the_earth) {
  EXPECT_EQ(ruler_of_plane(std::nullopt).diagonal({{0, 0}, {3, 4}}), 5);
  const Ruler earth = ruler_of_the_earth();
  EXPECT_NEAR(earth.diagonal({{170, 0}, {190, 0}}), 20 * equatorial_degree, 1e-6);
  EXPECT_NEAR(earth.diagonal({{7, 0}, {9, 90}}), quarter_meridian, 1e-3);
  EXPECT_NEAR(earth.diagonal({{-180, 0}, {10, 0}}), 2 * quarter_meridian, 500);
  EXPECT_NEAR(ruler_of_degrees(0.9).diagonal({{0, 0}, {201, 1}}), 2 * quarter_meridian, 500);
}

TEST(Ruler, boxes_that_meet_are_not_apart) {
  for (const Ruler& ruler : {ruler_of_the_earth(), ruler_of_plane(1)}) {
    EXPECT_EQ(ruler.between({{0, 0}, {2, 2}}, {{1, 1}, {3, 3}}), 0);
    EXPECT_EQ(ruler.between({{0, 0}, {2, 2}}, {{2, 0}, {3, 3}}), 0);
  }
  EXPECT_EQ(ruler_of_the_earth().between({{170, 0}, {190, 1}}, {{-175, 0}, {-171, 1}}), 0);
}

TEST(Ruler, boxes_are_as_far_apart_as_their_nearest_points) {
  const Ruler plane = ruler_of_plane(std::nullopt);
  EXPECT_EQ(plane.between({{0, 0}, {1, 1}}, {{4, 5}, {9, 9}}), 5);
  EXPECT_EQ(plane.between({{4, 5}, {9, 9}}, {{0, 0}, {1, 1}}), 5);
  EXPECT_EQ(plane.between({{0, 0}, {1, 9}}, {{4, -5}, {9, 3}}), 3);
  const Ruler earth = ruler_of_the_earth();
  EXPECT_NEAR(earth.between({{170, 0}, {175, 0}}, {{-175, 0}, {-170, 0}}), 10 * equatorial_degree,
              1e-6);
  EXPECT_NEAR(earth.between({{-175, 0}, {-170, 0}}, {{170, 0}, {175, 0}}), 10 * equatorial_degree,
              1e-6);
  EXPECT_NEAR(earth.between({{0, -5}, {9, 0}}, {{3, 90}, {4, 90}}), quarter_meridian, 1e-3);
}

// Meridians come together towards the poles, so boxes side by side are nearest at the parallel that
// both reach nearest to one: here 60 degrees, north or south. On a sphere of the Earth's mean
// radius the great circle over 10 degrees of it is 2 R asin(cos 60 sin 5) = 555.4 km long.
TEST(Ruler, boxes_side_by_side_on_the_earth_are_nearest_where_meridians_are) {
  const Ruler earth = ruler_of_the_earth();
  const double degree = std::numbers::pi / 180;
  const double wanted = 2 * 6371008.8 * std::asin(std::cos(60 * degree) * std::sin(5 * degree));
  EXPECT_NEAR(earth.between({{0, -10}, {10, 60}}, {{20, 5}, {30, 70}}) / wanted, 1, 5e-3);
  EXPECT_NEAR(earth.between({{0, -60}, {10, 10}}, {{20, -70}, {30, 5}}) / wanted, 1, 5e-3);
}

TEST(Ruler, writes_distances_with_three_digits_that_tell_and_all_before_the_point) {
  const Ruler earth = ruler_of_the_earth();
  EXPECT_EQ(earth.text(0), "0 km");
  EXPECT_EQ(earth.text(0.4567), "0.000457 km");
  EXPECT_EQ(earth.text(450), "0.450 km");
  EXPECT_EQ(earth.text(12345), "12.3 km");
  EXPECT_EQ(earth.text(99949), "99.9 km");
  EXPECT_EQ(earth.text(99951), "100 km");
  EXPECT_EQ(earth.text(9996), "10.0 km");
  EXPECT_EQ(earth.text(20003931), "20004 km");
  EXPECT_EQ(ruler_of_plane(0.3048).text(1524), "1.52 km");
  EXPECT_EQ(ruler_of_plane(std::nullopt).text(12), "12.0 units");
}

TEST(Ruler, writes_the_corners_of_a_box) {
  EXPECT_EQ(ruler_of_the_earth().text(Box{{10, 47.1234567}, {11.5, 48}}),
            "longitude 10 to 11.5, latitude 47.123457 to 48");
  EXPECT_EQ(ruler_of_plane(1).text(Box{{-3, 5}, {-3, 6}}), "x -3, y 5 to 6");
  EXPECT_EQ(ruler_of_plane(1).text(Box{{0.1 + 0.2, 5}, {0.3, 5.00000001}}), "x 0.3, y 5");
}

}  // namespace
}  // namespace thiessen
