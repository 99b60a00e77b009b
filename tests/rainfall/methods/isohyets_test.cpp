#include "rainfall/methods/isohyets.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

using Levels = std::vector<double>;

TEST(Isohyets, have_levels_strictly_between_the_least_and_the_largest_value) {
  EXPECT_EQ(isohyet_levels(10, 40, 10), (Levels{20, 30}));
  EXPECT_EQ(isohyet_levels(9.5, 40.5, 10), (Levels{10, 20, 30, 40}));
  EXPECT_EQ(isohyet_levels(-5, 5, 5), (Levels{0}));
  EXPECT_TRUE(isohyet_levels(11, 19, 10).empty());
  EXPECT_TRUE(isohyet_levels(10, 10, 10).empty());
  EXPECT_EQ(complaint_of([] { isohyet_levels(0, 100, 1e-3); }),
            "there would be more than 10000 isohyets | a larger 'interval' makes fewer");
}

TEST(Isohyets, without_an_interval_take_a_rounded_one) {
  EXPECT_EQ(isohyet_levels(0, 16, 0), (Levels{2, 4, 6, 8, 10, 12, 14}));
  EXPECT_EQ(isohyet_levels(3, 75, 0), (Levels{10, 20, 30, 40, 50, 60, 70}));
  EXPECT_EQ(isohyet_levels(0, 0.33, 0).size(), 6U);  // 0.05 to 0.3
}

using Line = std::vector<Point>;

bool is_east(Point p) {
  return p.x >= 0.5;
}

TEST(Isohyets, are_kept_where_something_holds) {
  EXPECT_EQ(parts_where({{1, 0}, {2, 0}}, is_east), (std::vector<Line>{{{1, 0}, {2, 0}}}));
  EXPECT_TRUE(parts_where({{0, 0}, {-2, 0}}, is_east).empty());
  // There and back, twice: ends lie where it still holds.
  EXPECT_EQ(parts_where({{-1, 0}, {1, 0}, {1, 4}, {-1, 4}, {-1, 6}, {3, 6}}, is_east),
            (std::vector<Line>{{{0.5, 0}, {1, 0}, {1, 4}, {0.5, 4}}, {{0.5, 6}, {3, 6}}}));
  EXPECT_TRUE(parts_where({{0.5, 0}, {0, 0}}, is_east).empty()) << "a point is no line";
}

TEST(Isohyets, that_are_closed_stay_whole_over_the_point_where_they_begin) {
  const Line square{{2, 0}, {2, 2}, {-1, 2}, {-1, 0}, {2, 0}};
  EXPECT_EQ(parts_where(square, is_east),
            (std::vector<Line>{{{0.5, 0}, {2, 0}, {2, 2}, {0.5, 2}}}));
  const Line whole{{2, 0}, {2, 2}, {1, 2}, {2, 0}};
  EXPECT_EQ(parts_where(whole, is_east), (std::vector<Line>{whole}));
  const Line begun_outside{{-1, 0}, {2, 0}, {2, 2}, {-1, 2}, {-1, 0}};
  EXPECT_EQ(parts_where(begun_outside, is_east),
            (std::vector<Line>{{{0.5, 0}, {2, 0}, {2, 2}, {0.5, 2}}}));
}

// One level, 2: two points between 0.5 and 2, four between 2 and 3.8.
TEST(Isohyets, mean_is_areas_times_mid_levels) {
  EXPECT_NEAR(isohyetal_mean(Levels{0.5, 1.9, 2.5, 3.2, 3.8, 3.6}, {0.5, 3.8}, 2),
              (2 * 1.25 + 4 * 2.9) / 6, 1e-15);
  EXPECT_EQ(isohyetal_mean(Levels{0, 0, 0}, {0, 0}, 5), 0);  // dry ground stays dry
  EXPECT_EQ(isohyetal_mean(Levels{7, 7}, {7, 7}, 5), 7);
}

}  // namespace
}  // namespace thiessen
