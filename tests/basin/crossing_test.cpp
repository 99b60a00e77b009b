#include "basin/crossing.h"

#include <gtest/gtest.h>
#include <utility>

#include <cmath>

#include "geometry/box.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

TEST(Crossing, of_an_edge_and_a_chord_is_their_common_point) {
  const Meeting meeting = meet({0, 0}, {4, 4}, {0, 4}, {4, 0});
  ASSERT_TRUE(meeting.crossing);
  EXPECT_EQ(meeting.crossing->point, (Point{2, 2}));
  EXPECT_EQ(meeting.crossing->along_edge, 0.5);
  EXPECT_EQ(meeting.crossing->along_chord, 0.5);
  EXPECT_TRUE(meeting.crossing->to_left);    // (4, 4) is left of (0, 4) to (4, 0)
  EXPECT_FALSE(meeting.crossing->entering);  // (4, 0) is right of the edge
  EXPECT_FALSE(meeting.touches());
}

TEST(Crossing, of_segments_apart_is_none) {
  EXPECT_FALSE(meet({0, 0}, {4, 4}, {3, 0}, {4, 1}).crossing);
  EXPECT_FALSE(meet({0, 0}, {1, 1}, {0, 4}, {4, 0}).crossing);
  EXPECT_FALSE(meet({0, 0}, {1, 0}, {2, 0}, {3, 0}).crossing);
}

// Basins are shifted to the right a little, and upwards less.
TEST(Crossing, at_an_end_goes_by_the_shift) {
  // A vertical edge up to, and from, a point of a chord to the right: shifted up it crosses below.
  const Meeting below = meet({1, -1}, {1, 0}, {0, 0}, {2, 0});
  EXPECT_TRUE(below.crossing);
  EXPECT_TRUE(below.b_on_chord);
  const Meeting above = meet({1, 0}, {1, 1}, {0, 0}, {2, 0});
  EXPECT_FALSE(above.crossing);
  EXPECT_TRUE(above.a_on_chord);
  // A chord that ends on a vertical edge: shifted right, the edge misses the one on its left side.
  EXPECT_FALSE(meet({0, -1}, {0, 1}, {-1, 0}, {0, 0}).crossing);
  EXPECT_TRUE(meet({0, -1}, {0, 1}, {0, 0}, {1, 0}).crossing);
}

TEST(Crossing, of_an_edge_along_a_chord_is_none) {
  const Meeting meeting = meet({0, 0}, {4, 4}, {1, 1}, {3, 3});
  EXPECT_FALSE(meeting.crossing);
  EXPECT_TRUE(meeting.from_on_edge);
  EXPECT_TRUE(meeting.to_on_edge);
  EXPECT_FALSE(meeting.a_on_chord);
}

// A chain through a point crosses a chord through it once or not at all, never half: the number of
// crossings has the parity of the sides of the chain's ends.
TEST(Crossing, of_a_chain_has_the_parity_of_its_ends) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const auto grid = [&] {
      return Point{static_cast<double>(seeded.whole(-3, 3)),
                   static_cast<double>(seeded.whole(-3, 3))};
    };
    // A closed triangle crosses a whole line, here a long chord, an even number of times.
    const Point a = grid(), b = grid(), c = grid();
    const Point from{-20, static_cast<double>(seeded.whole(-20, 20))};
    const Point to{20, static_cast<double>(seeded.whole(-20, 20))};
    if (a == b || b == c || c == a) continue;
    int crossings = 0;
    int inwards = 0;
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const Meeting meeting = meet(p, q, from, to);
      if (!meeting.crossing) continue;
      ++crossings;
      inwards += meeting.crossing->entering ? 1 : -1;
    }
    ASSERT_EQ(crossings % 2, 0);
    ASSERT_EQ(inwards, 0);
  }
}

// Neighbouring basins run along their common edge in opposite directions.
TEST(Crossing, has_the_same_point_whichever_way_either_of_the_two_runs) {
  Seeded seeded;
  int crossings = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(100000); ++round) {
    const Point offset = round % 2 == 0 ? Point{0, 0} : Point{500000, 4000000};
    const auto somewhere = [&] {
      return Point{offset.x + seeded.uniform(-1, 1), offset.y + seeded.uniform(-1, 1)};
    };
    const Point a = somewhere(), b = somewhere(), from = somewhere();
    Point to = somewhere();
    if (round % 3 == 0) {  // nearly parallel
      const double t = seeded.uniform(0, 1);
      to = {a.x + t * (b.x - a.x), seeded.near(a.y + t * (b.y - a.y), 3)};
    }
    if (a == b || from == to) continue;
    const Meeting meeting = meet(a, b, from, to);
    const Meeting edge_turned = meet(b, a, from, to);
    const Meeting chord_turned = meet(a, b, to, from);
    ASSERT_EQ(meeting.crossing.has_value(), edge_turned.crossing.has_value());
    ASSERT_EQ(meeting.crossing.has_value(), chord_turned.crossing.has_value());
    if (!meeting.crossing) continue;
    ++crossings;
    ASSERT_EQ(edge_turned.crossing->point, meeting.crossing->point);
    ASSERT_EQ(chord_turned.crossing->point, meeting.crossing->point);
    ASSERT_NE(edge_turned.crossing->to_left, meeting.crossing->to_left);
    ASSERT_NE(chord_turned.crossing->entering, meeting.crossing->entering);
    ASSERT_TRUE(box_of(a, b).contains(meeting.crossing->point));
    ASSERT_TRUE(box_of(from, to).contains(meeting.crossing->point));
  }
  EXPECT_GT(crossings, 1000);
}

}  // namespace
}  // namespace thiessen
