#include "geometry/signposts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr std::uint32_t first_number = 1000;  // numbers are not places in the sample

double distance(const Point& p, const Point& q) {
  return std::hypot(p.x - q.x, p.y - q.y);
}
double distance(const SpacePoint& p, const SpacePoint& q) {
  return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
}

// A sample whose numbers tell where the positions are, and what looking at each of them finds.
template <int Dimension>
class Sample {
 public:
  using Position = PositionIn<Dimension>;

  explicit Sample(std::vector<Position> positions) : positions_(std::move(positions)) {
    using Signpost = typename Signposts<Dimension>::Signpost;
    std::vector<Signpost> sample;
    for (const Position& p : positions_) {
      sample.push_back({p, first_number + static_cast<std::uint32_t>(sample.size())});
    }
    signposts_.set(std::move(sample));
  }

  const std::vector<Position>& positions() const { return positions_; }

  Position found(const Position& p) const {
    return positions_.at(signposts_.near(p).value() - first_number);
  }
  double nearest_distance(const Position& p) const {
    double least = HUGE_VAL;
    for (const Position& q : positions_) least = std::min(least, distance(p, q));
    return least;
  }
  /// How far the signposts found are in the mean, over how far the nearest are.
  double detour(const std::vector<Position>& sought) const {
    double found_way = 0;
    double least_way = 0;
    for (const Position& p : sought) {
      found_way += distance(p, found(p));
      least_way += nearest_distance(p);
    }
    return found_way / least_way;
  }

 private:
  std::vector<Position> positions_;
  Signposts<Dimension> signposts_;
};

template <typename Make>
auto several(std::size_t count, const Make& make) {
  std::vector<decltype(make())> positions;
  for (std::size_t i = 0; i < count; ++i) positions.push_back(make());
  return positions;
}

TEST(Signposts, without_any_find_none) {
  Signposts<2> signposts;
  EXPECT_EQ(signposts.near({0, 0}), std::nullopt);
  signposts.set({{{1, 1}, 5}});
  EXPECT_EQ(signposts.near({0, 0}), 5u);
  EXPECT_EQ(signposts.size(), 1u);
  signposts.set({});
  EXPECT_EQ(signposts.near({0, 0}), std::nullopt);
  EXPECT_EQ(signposts.size(), 0u);
}

TEST(Signposts, of_eight_or_fewer_find_the_nearest) {
  Seeded seeded;
  const auto anywhere = [&] { return Point{seeded.uniform(-1, 1), seeded.uniform(-1, 1)}; };
  for (std::size_t count = 1; count <= 8; ++count) {
    const Sample<2> sample(several(count, anywhere));
    for (const Point& p : several(100, anywhere)) {
      ASSERT_EQ(distance(p, sample.found(p)), sample.nearest_distance(p)) << count;
    }
  }
}

TEST(Signposts, find_a_random_sample_s_own_positions) {
  Seeded seeded;
  for (const std::size_t count : {9u, 16u, 17u, 33u, 100u, 1000u, 4097u}) {
    const Sample<2> plane(several(count, [&] {
      return Point{seeded.uniform(-1, 1), seeded.uniform(-1e9, 1e9)};
    }));
    for (const Point& p : plane.positions()) ASSERT_EQ(plane.found(p), p) << count;
    const Sample<3> space(several(count, [&] {
      return SpacePoint{seeded.uniform(-1, 1), seeded.uniform(-1, 1), seeded.uniform(-2, -1)};
    }));
    for (const SpacePoint& p : space.positions()) ASSERT_EQ(space.found(p), p) << count;
  }
}

// The bounds are generous: measured are 1.09 to 1.21.
TEST(Signposts, of_an_even_sample_are_hardly_farther_than_the_nearest) {
  Seeded seeded;
  const auto in_square = [&] { return Point{seeded.uniform(-1, 1), seeded.uniform(-1, 1)}; };
  const auto in_cube = [&] {
    return SpacePoint{seeded.uniform(-1, 1), seeded.uniform(-1, 1), seeded.uniform(-1, 1)};
  };
  for (const std::size_t count : {10u, 100u, 1000u, 10000u}) {
    EXPECT_LT(Sample<2>(several(count, in_square)).detour(several(1000, in_square)), 1.5);
    EXPECT_LT(Sample<3>(several(count, in_cube)).detour(several(1000, in_cube)), 1.5);
  }
}

TEST(Signposts, of_a_lattice_a_line_a_needle_and_a_road_are_hardly_farther_than_the_nearest) {
  Seeded seeded;
  const auto along = [&](double x, double y, double thickness) {
    const double t = seeded.uniform(0, 1e6);
    return Point{x * t + seeded.uniform(0, thickness), y * t + seeded.uniform(0, thickness)};
  };
  const auto compare = [](const auto& make, double bound) {
    EXPECT_LT(Sample<2>(several(3000, make)).detour(several(1000, make)), bound);
  };
  for (const double thickness : {0.0, 1e-6, 1.0}) {
    compare([&] { return along(1, 0, thickness); }, 1.5);
    compare([&] { return along(0, 1, thickness); }, 1.5);
    compare([&] { return along(1, -2, thickness); }, 1.5);
  }
  compare(
      [&] {
        const double t = std::floor(seeded.uniform(0, 1e6));
        return Point{std::round(t * 70) / 100, std::round(t * 20 + 1000 * std::sin(t / 500)) / 100};
      },
      1.5);
  std::vector<Point> lattice;
  for (int i = 0; i < 4096; ++i) lattice.push_back({double(i % 64), double(i / 64)});
  const auto between = [&] { return Point{seeded.uniform(0, 63), seeded.uniform(0, 63)}; };
  EXPECT_LT(Sample<2>(lattice).detour(several(1000, between)), 1.8);
}

TEST(Signposts, are_of_the_cluster_where_the_position_is) {
  Seeded seeded;
  for (const Point& apart : {Point{1e6, 0}, Point{0, 1e6}, Point{1e6, 1e6}, Point{-1e6, 1e6}}) {
    for (const std::uint64_t first_share : {1u, 30u, 50u, 93u}) {
      const auto in_either = [&] {
        const double side = seeded.below(100) < first_share ? 0 : 1;
        return Point{side * apart.x + seeded.uniform(0, 1e-3),
                     side * apart.y + seeded.uniform(0, 1e-3)};
      };
      const Sample<2> sample(several(3001, in_either));
      for (const Point& p : several(500, in_either)) {
        ASSERT_LT(distance(p, sample.found(p)), 2e-3) << apart.x << ' ' << apart.y;
      }
    }
  }
}

TEST(Signposts, may_be_at_one_place) {
  const Sample<3> equal(std::vector<SpacePoint>(10000, {3, -4, 5}));
  for (const SpacePoint& p : {SpacePoint{3, -4, 5}, SpacePoint{0, 0, 0}, SpacePoint{9, 9, 9}}) {
    EXPECT_EQ(equal.found(p), (SpacePoint{3, -4, 5}));
  }
  std::vector<Point> positions(10000, {3, -4});
  positions[17] = {3, 1e9};
  EXPECT_EQ(Sample<2>(positions).found({3, 2e9}), (Point{3, 1e9}));
}

TEST(Signposts, take_minus_zero_for_zero) {
  std::vector<Point> positions;
  for (int i = 0; i < 100; ++i) positions.push_back({i % 2 == 0 ? 0.0 : -0.0, double(i)});
  const Sample<2> sample(positions);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(sample.found({0.0, double(i)}).y, i);
    EXPECT_EQ(sample.found({-0.0, double(i)}).y, i);
  }
}

TEST(Signposts, are_found_however_large_the_coordinates) {
  Seeded seeded;
  for (const double scale : {1e-300, 1e60, 1e154, 1e200, DBL_MAX}) {
    const auto anywhere = [&] {
      return Point{scale * seeded.uniform(-1, 1), scale * seeded.uniform(-1, 1)};
    };
    const Sample<2> sample(several(1000, anywhere));
    for (const Point& p : several(100, anywhere)) sample.found(p);  // throws unless a number given
    for (const double far : {-DBL_MAX, 0.0, DBL_MAX}) sample.found({far, -far});
  }
  const auto whole = [&] {
    return Point{1e60 * seeded.uniform(-1, 1), 1e60 * seeded.uniform(-1, 1)};
  };
  EXPECT_LT(Sample<2>(several(1000, whole)).detour(several(500, whole)), 1.5);
}

}  // namespace
}  // namespace thiessen
