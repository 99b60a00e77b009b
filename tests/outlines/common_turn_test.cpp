// Shapes brought to one turn of longitudes, in quarters of a degree, where all sums are exact.
#include "outlines/common_turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/box.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

Polygon strip(double west, double width) {
  const double south = std::fmod(std::abs(west), 50);
  return {{{west, south}, {west + width, south}, {west + width, south + 5}, {west, south + 5}},
          {{{west, south + 1}, {west, south + 2}, {west + width / 2, south + 2}}}};
}

void bring(std::vector<CurvedShape>& shapes) {
  std::vector<CurvedShape*> all;
  for (CurvedShape& shape : shapes) all.push_back(&shape);
  bring_to_common_turn(all);
}

std::vector<Polygon> parts_of(const std::vector<CurvedShape>& shapes) {
  std::vector<Polygon> parts;
  for (const CurvedShape& shape : shapes)
    parts.insert(parts.end(), shape.shape.begin(), shape.shape.end());
  return parts;
}

double width_of(const std::vector<Polygon>& parts) {
  Box box;
  for (const Polygon& part : parts) {
    for (const Point p : part.outer) box.take_in(p);
  }
  return box.width();
}

/// The fewest degrees that hold all parts, each moved by whole turns: it begins where one of them
/// does.
double fewest_degrees(const std::vector<Polygon>& parts) {
  double fewest = HUGE_VAL;
  for (const Polygon& first : parts) {
    double width = 0;
    for (const Polygon& part : parts) {
      const double way = part.outer[0].x - first.outer[0].x;
      const double east = way - 360 * std::floor(way / 360);
      width = std::max(width, east + part.outer[1].x - part.outer[0].x);
    }
    fewest = std::min(fewest, width);
  }
  return fewest;
}

std::vector<CurvedShape> random_shapes(Seeded& seeded, double widest) {
  std::vector<CurvedShape> shapes(1 + seeded.below(4));
  for (CurvedShape& shape : shapes) {
    for (std::uint64_t i = 1 + seeded.below(3); i-- > 0;) {
      const double west = static_cast<double>(seeded.whole(-2000, 2000)) / 4;
      shape.shape.push_back(strip(west, std::ceil(seeded.uniform(0, 4 * widest)) / 4));
    }
  }
  return shapes;
}

bool are_same(const std::vector<Polygon>& a, const std::vector<Polygon>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Polygon& p, const Polygon& q) {
    return p.outer == q.outer && p.holes == q.holes;
  });
}

TEST(CommonTurn, law_1_they_lie_within_the_fewest_degrees_that_hold_them) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(1000); ++round) {
    std::vector<CurvedShape> shapes = random_shapes(seeded, 40);
    const double fewest = fewest_degrees(parts_of(shapes));
    if (fewest >= 360) continue;
    bring(shapes);
    ASSERT_EQ(width_of(parts_of(shapes)), fewest);
  }
}

TEST(CommonTurn, law_2_each_part_is_moved_by_whole_turns_and_with_its_holes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(300); ++round) {
    std::vector<CurvedShape> shapes = random_shapes(seeded, 40);
    const std::vector<Polygon> before = parts_of(shapes);
    if (fewest_degrees(before) >= 360) continue;
    bring(shapes);
    std::vector<Polygon> after = parts_of(shapes);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) {
      const double moved = after[i].outer[0].x - before[i].outer[0].x;
      ASSERT_EQ(std::remainder(moved, 360), 0);
      for (Point& p : after[i].outer) p.x -= moved;
      for (Point& p : after[i].holes[0]) p.x -= moved;
    }
    ASSERT_TRUE(are_same(after, before));
  }
}

// Wherever they are, over the antimeridian or turns away.
TEST(CommonTurn, law_3_what_lies_within_the_fewest_degrees_stays_bit_for_bit) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(300); ++round) {
    std::vector<CurvedShape> shapes = random_shapes(seeded, 40);
    if (fewest_degrees(parts_of(shapes)) >= 360) continue;
    bring(shapes);
    const double far = 0.1 + 360 * static_cast<double>(seeded.whole(-2, 2));
    for (CurvedShape& shape : shapes) {
      for (Polygon& part : shape.shape) {
        for (Point& p : part.outer) p.x += far;
      }
    }
    const std::vector<Polygon> before = parts_of(shapes);
    bring(shapes);
    ASSERT_TRUE(are_same(parts_of(shapes), before));
  }
}

TEST(CommonTurn, law_4_what_reaches_all_round_the_earth_is_cut_at_the_antimeridian) {
  std::vector<CurvedShape> shapes(3);
  shapes[0].shape = {{{{-100, 0}, {60, 0}, {60, 5}, {-100, 5}}, {}}};
  shapes[1].shape = {{{{50, 0}, {170, 0}, {170, 5}, {50, 5}}, {}}};
  shapes[2].shape = {{{{160, 7}, {270, 7}, {270, 9}, {160, 9}}, {}}};
  bring(shapes);
  EXPECT_EQ(shapes[0].shape[0].outer, (Ring{{-100, 0}, {60, 0}, {60, 5}, {-100, 5}}));
  EXPECT_EQ(shapes[1].shape[0].outer, (Ring{{50, 0}, {170, 0}, {170, 5}, {50, 5}}));
  ASSERT_EQ(shapes[2].shape.size(), 2u);
  EXPECT_EQ(shapes[2].shape[0].outer, (Ring{{-180, 7}, {-90, 7}, {-90, 9}, {-180, 9}}));
  EXPECT_EQ(shapes[2].shape[1].outer, (Ring{{160, 7}, {180, 7}, {180, 9}, {160, 9}}));
}

TEST(CommonTurn, of_the_two_sides_of_the_antimeridian_is_one_side) {
  std::vector<CurvedShape> shapes(2);
  shapes[0].shape = {{{{-180, 0}, {-170, 0}, {-175, 5}}, {}}};
  shapes[1].shape = {{{{170, 0}, {180, 0}, {175, 5}}, {}}};
  bring(shapes);
  EXPECT_EQ(shapes[0].shape[0].outer, (Ring{{180, 0}, {190, 0}, {185, 5}}));
  EXPECT_EQ(shapes[1].shape[0].outer, (Ring{{170, 0}, {180, 0}, {175, 5}}));
}

}  // namespace
}  // namespace thiessen
