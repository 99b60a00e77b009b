#include "earth/nearest/one_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "earth/nearest/in_space.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

using Numbers = std::vector<std::uint32_t>;

constexpr double micrometre = 1 / 111.3e9;  // of latitude, in degrees

/// Places by comparing all pairs, for few positions.
Numbers by_all_pairs(const std::vector<Point>& positions) {
  Numbers place(positions.size());
  std::iota(place.begin(), place.end(), 0u);
  const auto near = [&](std::size_t i, std::size_t j) {
    return length(in_space(positions[i], Metric::geodesic) -
                  in_space(positions[j], Metric::geodesic)) <= one_place;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < place.size(); ++i) {
      for (std::size_t j = 0; j < place.size(); ++j) {
        if (place[i] == place[j] || !near(i, j)) continue;
        const auto less = [&](std::uint32_t a, std::uint32_t b) {
          return positions[a] < positions[b] || (positions[a] == positions[b] && a < b);
        };
        place[i] = place[j] = less(place[i], place[j]) ? place[i] : place[j];
        changed = true;
      }
    }
  }
  return place;
}

TEST(OnePlace, is_within_a_micrometre) {
  EXPECT_EQ(joined_positions(std::vector<Point>{{10.1, 47.1}, {10.100000000001, 47.1}, {10.5, 47}}),
            (Numbers{0, 0, 2}));
  const std::vector<Point> apart{{10, 47}, {10, 47 + 1.02 * micrometre}};
  EXPECT_EQ(joined_positions(apart), (Numbers{0, 1}));
  const std::vector<Point> near{{10, 47 + 0.98 * micrometre}, {10, 47}};
  EXPECT_EQ(joined_positions(near), (Numbers{1, 1})) << "the least stands for the place";
}

TEST(OnePlace, goes_over_the_antimeridian_and_the_poles) {
  EXPECT_EQ(joined_positions(std::vector<Point>{{180, 5}, {-180 + 1e-13, 5}}), (Numbers{1, 1}));
  EXPECT_EQ(joined_positions(std::vector<Point>{{0, 90}, {-77, 90 - 0.5 * micrometre}}),
            (Numbers{1, 1}));
}

// Law: a chain of near pairs is one place, in whatever order it comes, and however long it is.
// Degrees tell who is alone up to 80 degrees of latitude and 179 of longitude.
TEST(OnePlace, does_not_end_where_degrees_tell_no_more) {
  const double near = 0.9 * micrometre;
  EXPECT_EQ(joined_positions(std::vector<Point>{{10, 80}, {10, 80 + near}}), (Numbers{0, 0}));
  EXPECT_EQ(joined_positions(std::vector<Point>{{10, -80 - near}, {10, -80}}), (Numbers{0, 0}));
  EXPECT_EQ(joined_positions(std::vector<Point>{{179, 10}, {179 + near, 10}}), (Numbers{0, 0}));
  EXPECT_EQ(joined_positions(std::vector<Point>{{10, 79.9}, {10 + 5 * near, 79.9}}),
            (Numbers{0, 0}))
      << "a degree of longitude is short there";
}

TEST(OnePlace, is_a_whole_chain_in_any_order) {
  std::vector<Point> chain;
  for (int i = 0; i < 200; ++i) chain.push_back({20, 40 + i * 0.9 * micrometre});
  chain.push_back({20, 40 + 202 * 0.9 * micrometre});
  Seeded seeded;
  for (std::size_t i = chain.size(); i > 1; --i) std::swap(chain[i - 1], chain[seeded.below(i)]);
  const Numbers places = joined_positions(chain);
  EXPECT_EQ(places, by_all_pairs(chain));
  EXPECT_EQ(std::set<std::uint32_t>(places.begin(), places.end()).size(), 2u);
}

// Law: the places are those that comparing all pairs gives, for clusters of every size from far
// less than a micrometre to a metre.
TEST(OnePlace, agrees_with_all_pairs) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    const Point centre{seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
    const double size = micrometre * std::pow(10, seeded.uniform(-1, 6));
    std::vector<Point> positions;
    for (std::uint64_t i = 1 + seeded.below(80); i-- > 0;) {
      positions.push_back({centre.x + seeded.uniform(0, size),
                           std::clamp(centre.y + seeded.uniform(0, size), -90.0, 90.0)});
      if (seeded.below(4) == 0) positions.push_back(positions[seeded.below(positions.size())]);
    }
    ASSERT_EQ(joined_positions(positions), by_all_pairs(positions)) << size / micrometre;
  }
}

// 100,000 positions in a millimetre, and as many along one parallel: neither is quadratic.
TEST(OnePlace, takes_no_quadratic_time) {
  Seeded seeded;
  std::vector<Point> positions;
  for (int i = 0; i < 100'000; ++i) {
    positions.push_back(
        {8 + seeded.uniform(0, 1000 * micrometre), 50 + seeded.uniform(0, 1000 * micrometre)});
    positions.push_back({-100 + i * 1e-3, 50});
  }
  const Numbers places = joined_positions(positions);
  EXPECT_EQ(places[3], 3u);
}

}  // namespace
}  // namespace thiessen
