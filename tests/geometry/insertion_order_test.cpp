#include "geometry/insertion_order.h"

#include <gtest/gtest.h>
#include <utility>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>
#include <vector>

#include "geometry/coordinates.h"
#include "geometry/hilbert.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

double distance(const Point& p, const Point& q) {
  return std::hypot(p.x - q.x, p.y - q.y);
}
double distance(const SpacePoint& p, const SpacePoint& q) {
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

std::vector<Point> in_a_square(Seeded& seeded, std::size_t count, double side) {
  std::vector<Point> points(count);
  for (Point& p : points) p = {seeded.uniform(0, side), seeded.uniform(0, side)};
  return points;
}

std::vector<SpacePoint> in_a_cube(Seeded& seeded, std::size_t count, double side) {
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) {
    p = {seeded.uniform(0, side), seeded.uniform(0, side), seeded.uniform(0, side)};
  }
  return points;
}

template <typename Position>
void expect_each_once(const std::vector<Position>& points) {
  std::vector<std::uint32_t> order = insertion_order(points);
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_EQ(order, all);
}

// The points of the last round, seven in eight, in their order.
template <typename Position>
std::vector<Position> last_round(const std::vector<Position>& points) {
  const InsertionRounds rounds(points.size());
  std::vector<Position> last;
  for (const std::uint32_t i : insertion_order(points)) {
    if (rounds.of(i) + 1 == rounds.count()) last.push_back(points[i]);
  }
  return last;
}

template <typename Position>
double way_along(const std::vector<Position>& points) {
  double way = 0;
  for (std::size_t i = 1; i < points.size(); ++i) way += distance(points[i - 1], points[i]);
  return way;
}

TEST(InsertionOrder, names_each_point_once) {
  Seeded seeded;
  for (const std::size_t count : {0u, 1u, 2u, 9u, 63u, 64u, 65u, 255u, 257u, 511u, 513u, 5000u}) {
    std::vector<Point> points = in_a_square(seeded, count, 1);
    expect_each_once(points);
    for (Point& p : points) p.x = std::floor(40 * p.x);
    expect_each_once(points);
    expect_each_once(in_a_cube(seeded, count, 1e6));
  }
}

TEST(InsertionOrder, names_each_point_once_over_all_doubles) {
  Seeded seeded;
  std::vector<Point> points(20000);
  for (Point& p : points) {
    p = {seeded.uniform(-1, 1) * std::pow(10, seeded.uniform(-320, 308)),
         seeded.uniform(-1, 1) * std::pow(10, seeded.uniform(-320, 308))};
  }
  expect_each_once(points);
  for (Point& p : points) p = {seeded.below(2) == 0 ? -DBL_MAX : DBL_MAX, seeded.uniform(0, 1)};
  expect_each_once(points);
  for (Point& p : points) p = {DBL_TRUE_MIN * static_cast<double>(seeded.below(100)), -0.0};
  expect_each_once(points);
}

TEST(InsertionOrder, is_the_same_for_the_same_input) {
  Seeded seeded;
  const std::vector<Point> points = in_a_square(seeded, 5000, 3);
  const std::vector<Point> copy = points;
  EXPECT_EQ(insertion_order(points), insertion_order(copy));
}

TEST(InsertionRounds, grow_eightfold) {
  for (const std::size_t count : {1000u, 100000u, 1000000u}) {
    const InsertionRounds rounds(count);
    std::vector<double> size(rounds.count(), 0);
    for (std::size_t i = 0; i < count; ++i) ++size.at(rounds.of(i));
    // Points are left to earlier rounds by a chance of 1/8 each: six deviations of a binomial.
    double share = 1;
    for (std::size_t round = size.size(); round-- > 0;) {
      const double chance = round == 0 ? share : share * 7 / 8;
      const double mean = chance * static_cast<double>(count);
      EXPECT_NEAR(size[round], mean, 6 * std::sqrt(mean)) << count << ' ' << round;
      share /= 8;
    }
    const double first = static_cast<double>(count) / std::pow(8, rounds.count() - 1);
    EXPECT_GE(first, 64);
    EXPECT_LT(first, 512);
  }
}

TEST(InsertionRounds, of_few_points_are_one) {
  for (const std::size_t count : {0u, 1u, 64u, 511u}) EXPECT_EQ(InsertionRounds(count).count(), 1u);
  EXPECT_EQ(InsertionRounds(512).count(), 2u);
}

TEST(InsertionRounds, do_not_follow_the_columns_of_a_lattice) {
  // Of 1000 columns of 1000 rows, each sends an eighth of its points to earlier rounds, and no
  // more than chance has it: 5.5 deviations of a binomial.
  const InsertionRounds rounds(1000000);
  for (std::size_t column = 0; column < 1000; ++column) {
    int early_down = 0;
    int early_along = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
      early_down += rounds.of(column + 1000 * i) + 1 < rounds.count() ? 1 : 0;
      early_along += rounds.of(1000 * column + i) + 1 < rounds.count() ? 1 : 0;
    }
    EXPECT_NEAR(early_down, 125, 58) << column;
    EXPECT_NEAR(early_along, 125, 58) << column;
  }
}

TEST(InsertionOrder, goes_through_the_rounds_and_along_the_curve_in_each) {
  std::vector<Point> points;
  for (int i = 0; i < 256 * 256; ++i) points.push_back({i % 256 + 0.5, std::floor(i / 256) + 0.5});
  const InsertionRounds rounds(points.size());
  const HilbertGrid<2> grid({0.5, 0.5}, {255.5, 255.5});
  const std::vector<std::uint32_t> order = insertion_order(points);
  const auto place = [&](std::uint32_t i) {
    return std::pair(rounds.of(i), grid.distance(points[i]) >> 16);
  };
  for (std::size_t i = 1; i < order.size(); ++i) {
    ASSERT_LE(place(order[i - 1]), place(order[i])) << i;
  }
}

TEST(InsertionOrder, in_space_goes_through_the_rounds_and_along_the_curve_in_each) {
  std::vector<SpacePoint> points;
  for (int i = 0; i < 32 * 32 * 32; ++i) {
    points.push_back({double(i % 32), double(i / 32 % 32), double(i / 1024)});
  }
  const InsertionRounds rounds(points.size());
  const HilbertGrid<3> grid({0, 0, 0}, {31, 31, 31});
  const std::vector<std::uint32_t> order = insertion_order(points);
  const auto place = [&](std::uint32_t i) {
    return std::pair(rounds.of(i), grid.distance(points[i]) >> 15);
  };
  for (std::size_t i = 1; i < order.size(); ++i) {
    ASSERT_LE(place(order[i - 1]), place(order[i])) << i;
  }
}

// The way along the curve through n random points of a square of area A is 0.979 sqrt(n A) long: in
// a simulation of the textbook's curve (distance to cell, digit by digit) with 10 times 10^6
// points. In space it is 1.05 (n^2 V)^(1/3) along the curve of J. Skilling (2004), which is turned
// otherwise.
TEST(InsertionOrder, takes_the_way_of_the_curve_through_random_points) {
  Seeded seeded;
  const std::vector<Point> plane = last_round(in_a_square(seeded, 200000, 7));
  const double in_plane = 7 * std::sqrt(static_cast<double>(plane.size()));
  EXPECT_NEAR(way_along(plane) / in_plane, 0.979, 0.01);

  const std::vector<SpacePoint> space = last_round(in_a_cube(seeded, 200000, 7));
  const double in_space = 7 * std::pow(static_cast<double>(space.size()), 2. / 3);
  EXPECT_NEAR(way_along(space) / in_space, 1.05, 0.03);
}

TEST(InsertionOrder, orders_clusters_inside) {
  Seeded seeded;
  std::vector<Point> points = in_a_square(seeded, 100000, 1e-3);
  for (std::size_t i = 0; i < points.size(); i += 2) {
    points[i] = {points[i].x + 1e6, points[i].y + 1e6};
  }
  std::vector<Point> last = last_round(points);
  const auto far = std::find_if(last.begin(), last.end(), [](const Point& p) { return p.x > 1; });
  ASSERT_TRUE(std::all_of(far, last.end(), [](const Point& p) { return p.x > 1; }));
  for (const std::vector<Point>& cluster :
       {std::vector<Point>(last.begin(), far), std::vector<Point>(far, last.end())}) {
    ASSERT_GT(cluster.size(), 40000u);
    const double root = std::sqrt(static_cast<double>(cluster.size()));
    EXPECT_NEAR(way_along(cluster) / (1e-3 * root), 0.979, 0.02);
  }
}

TEST(InsertionOrder, orders_clusters_of_clusters_inside) {
  Seeded seeded;
  std::vector<SpacePoint> points(50000);
  const auto corner = [&] { return static_cast<double>(seeded.below(2)); };
  for (SpacePoint& p : points) {
    const auto coordinate = [&] {
      return corner() + 1e-4 * corner() + 1e-8 * corner() + 1e-12 * corner();
    };
    p = {coordinate(), coordinate(), coordinate()};
  }
  // 8 clusters, 64 in those, 512 in those, each of 8 points in whose midst steps are short.
  std::vector<SpacePoint> last = last_round(points);
  std::size_t longer[3] = {};
  for (std::size_t i = 1; i < last.size(); ++i) {
    const double step = distance(last[i - 1], last[i]);
    if (step > 0.5) ++longer[0];
    if (step > 0.5e-4) ++longer[1];
    if (step > 0.5e-8) ++longer[2];
  }
  EXPECT_EQ(longer[0], 7u);
  EXPECT_EQ(longer[1], 63u);
  EXPECT_EQ(longer[2], 511u);
}

double way_along_line(Seeded& seeded, Point direction, double thickness) {
  std::vector<Point> points(20000);
  for (Point& p : points) {
    const double t = seeded.uniform(0, 1e6);
    p = {t * direction.x, t * direction.y + seeded.uniform(0, thickness)};
  }
  return way_along(last_round(points)) / (1e6 * std::hypot(direction.x, direction.y));
}

// Along the axes and the diagonals the curve never turns back; what is longer than the line comes
// from points that share a cell. Along others it may, by half a square in each of 14 halvings.
TEST(InsertionOrder, follows_a_line) {
  Seeded seeded;
  for (const double thickness : {0.0, 1e-9}) {
    for (const Point direction : {Point{1, 0}, Point{0, 1}, Point{1, 1}, Point{1, -1}}) {
      EXPECT_LT(way_along_line(seeded, direction, thickness), 2.5)
          << direction.x << ' ' << direction.y;
    }
    EXPECT_LT(way_along_line(seeded, {3, 1}, thickness), 1 + 14 / 2);
  }
}

TEST(InsertionOrder, takes_a_million_equal_points) {
  std::vector<Point> points(1000000, {3, -4});
  expect_each_once(points);
  points[777777] = {3, 5};
  expect_each_once(points);
  expect_each_once(std::vector<SpacePoint>(1000000, {3, -4, 5}));
}

TEST(InsertionOrder, takes_points_that_crowd_towards_one) {
  // Each tenth of the way to the origin holds as many points; the last tenth's tenth again.
  Seeded seeded;
  std::vector<Point> points(100000);
  for (Point& p : points) p = {std::pow(10, seeded.uniform(-300, 0)), 0};
  expect_each_once(points);
  EXPECT_LT(way_along(last_round(points)), 2.5);
}

}  // namespace
}  // namespace thiessen
