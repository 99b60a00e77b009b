// Which points of a list are equal, found by hashing.
#include "geometry/equal_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

using Numbers = std::vector<std::uint32_t>;

// As places were found before: in a tree.
Numbers by_tree(const std::vector<Point>& points) {
  std::map<Point, std::uint32_t> known;
  Numbers first;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    first.push_back(known.emplace(points[i], i).first->second);
  return first;
}

TEST(EqualPoints, law_1_each_has_the_number_of_the_first_that_is_equal) {
  const std::vector<Point> points{{3, 1}, {0, 0}, {3, 1}, {1, 3}, {0, 0}, {3, 1}};
  EXPECT_EQ(first_equal_points(points), (Numbers{0, 1, 0, 3, 1, 0}));
  EXPECT_EQ(first_equal_points({}), Numbers{});
}

TEST(EqualPoints, law_2_zero_and_minus_zero_are_equal) {
  const std::vector<Point> points{{0.0, -0.0}, {-0.0, 0.0}, {0, 0}, {0, 5e-324}};
  EXPECT_EQ(first_equal_points(points), (Numbers{0, 0, 0, 3}));
}

// Powers of two, whose bits all lie at one end, lattices and doubles that are an ulp apart.
TEST(EqualPoints, law_3_they_are_those_that_a_tree_finds) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    std::vector<Point> points;
    const std::size_t count = seeded.below(3000);
    const double side = std::ldexp(1.0, static_cast<int>(seeded.below(40)) - 20);
    for (std::size_t i = 0; i < count; ++i) {
      Point p{side * static_cast<double>(seeded.below(40)),
              side * static_cast<double>(seeded.below(40))};
      if (seeded.below(4) == 0) p.x = std::nextafter(p.x, 1e300);
      if (seeded.below(4) == 0) p.y = -p.y;
      points.push_back(p);
    }
    EXPECT_EQ(first_equal_points(points), by_tree(points));
  }
}

}  // namespace
}  // namespace thiessen
