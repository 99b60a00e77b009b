#include "outlines/antimeridian.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "outlines/ellipsoid_strip.h"
#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

TEST(Antimeridian, leaves_what_it_does_not_cross_bit_for_bit) {
  const MultiPolygon shape = {{{{-180, 0.1}, {180, 0.1}, {180, 90}, {-180, 90}}, {}},
                              {{{170.1, -1}, {180, -3}, {170.1, -0.3}}, {}}};
  CurvedShape cut{shape, {}};
  cut_at_antimeridian(cut);
  ASSERT_EQ(cut.shape.size(), 2U);
  EXPECT_EQ(cut.shape[0].outer, shape[0].outer);
  EXPECT_EQ(cut.shape[1].outer, shape[1].outer);
}

TEST(Antimeridian, cuts_into_parts_on_either_side) {
  CurvedShape cut{{{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {}}}, {}};
  cut_at_antimeridian(cut);
  ASSERT_EQ(cut.shape.size(), 2U);
  EXPECT_EQ(cut.shape[0].outer, (Ring{{-180, 0}, {-170, 0}, {-170, 10}, {-180, 10}}));
  EXPECT_EQ(cut.shape[1].outer, (Ring{{170, 0}, {180, 0}, {180, 10}, {170, 10}}));
}

TEST(Antimeridian, edges_along_it_belong_to_the_side_of_the_interior) {
  CurvedShape east{{{{{180, 0}, {190, 0}, {190, 10}, {180, 10}, {180, 5}}, {}}}, {}};
  cut_at_antimeridian(east);
  ASSERT_EQ(east.shape.size(), 1U);
  EXPECT_EQ(east.shape[0].outer, (Ring{{-180, 0}, {-170, 0}, {-170, 10}, {-180, 10}, {-180, 5}}));
  // A hole whose western side is the antimeridian.
  CurvedShape holed{
      {{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {{{180, 3}, {180, 6}, {185, 6}, {185, 3}}}}},
      {}};
  const double area = area_on_earth(holed);
  cut_at_antimeridian(holed);
  EXPECT_EQ(validity_fault(holed.shape), "");
  EXPECT_NEAR(area_on_earth(holed) / area, 1, 1e-14);
}

TEST(Antimeridian, crosses_where_rings_touch) {
  // Two triangles that meet in a point of the antimeridian.
  CurvedShape cut{{{{{170, 0}, {180, 5}, {170, 10}}, {}}, {{{180, 5}, {190, 0}, {190, 10}}, {}}},
                  {}};
  cut_at_antimeridian(cut);
  ASSERT_EQ(cut.shape.size(), 2U);
  EXPECT_EQ(validity_fault(cut.shape), "");
}

TEST(Antimeridian, neighbours_are_cut_at_one_point) {
  CurvedShape north{{{{{170, 1.1}, {190.75, 3.3}, {171, 20}}, {}}}, {}};
  // The same edge the other way, a turn further on.
  CurvedShape south{{{{{550.75, 3.3}, {530, 1.1}, {540, -20}}, {}}}, {}};
  cut_at_antimeridian(north);
  cut_at_antimeridian(south);
  const auto crossing = [](const CurvedShape& shape, double from, double to) {
    std::vector<double> found;
    for (const Polygon& polygon : shape.shape) {
      for (const Point point : polygon.outer) {
        if (point.x == 180 && point.y > from && point.y < to) found.push_back(point.y);
      }
    }
    return found;
  };
  ASSERT_EQ(crossing(north, 1.1, 3.3).size(), 1U);
  EXPECT_EQ(crossing(north, 1.1, 3.3), crossing(south, 1.1, 3.3));
}

TEST(Antimeridian, pieces_of_an_edge_share_its_bulge) {
  CurvedShape cut{{{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {}}}, {{8, 0, 100, 0}}};
  cut_at_antimeridian(cut);
  ASSERT_EQ(cut.bulges.size(), 2U);
  double sum = 0;
  for (std::size_t part = 0; part < 2; ++part) {
    ASSERT_EQ(cut.bulges[part].size(), cut.shape[part].outer.size());
    EXPECT_DOUBLE_EQ(std::accumulate(cut.bulges[part].begin(), cut.bulges[part].end(), 0.0), 54);
    sum += std::accumulate(cut.bulges[part].begin(), cut.bulges[part].end(), 0.0);
  }
  EXPECT_DOUBLE_EQ(sum, 108);
}

using Line = std::vector<Point>;

TEST(Antimeridian, leaves_lines_that_only_touch_it_bit_for_bit) {
  for (const Line& line : {Line{{170.1, 0}, {180, 5.1}, {170, 10}}, Line{{180, 0}, {180, 10}},
                           Line{{-180, 0}, {-170, 3}, {-180, 5}}, Line{{-180, 1}, {180, 1}}}) {
    EXPECT_EQ(cut_at_antimeridian(line), std::vector<Line>{line});
  }
}

// By hand: from (170, 0) to (190, 10) the antimeridian is met halfway, at latitude 5.
TEST(Antimeridian, cuts_lines_where_they_meet_it) {
  EXPECT_EQ(cut_at_antimeridian(Line{{170, 0}, {190, 10}, {200, 10}}),
            (std::vector<Line>{{{170, 0}, {180, 5}}, {{-180, 5}, {-170, 10}, {-160, 10}}}));
  EXPECT_EQ(cut_at_antimeridian(Line{{190, 10}, {170, 0}}),
            (std::vector<Line>{{{-170, 10}, {-180, 5}}, {{180, 5}, {170, 0}}}));
  EXPECT_EQ(cut_at_antimeridian(Line{{180, 0}, {183, 1}}),
            (std::vector<Line>{{{-180, 0}, {-177, 1}}}));
  EXPECT_EQ(cut_at_antimeridian(Line{{170, 0}, {180, 1}, {180, 2}, {190, 3}}),
            (std::vector<Line>{{{170, 0}, {180, 1}, {180, 2}}, {{-180, 2}, {-170, 3}}}));
  EXPECT_EQ(cut_at_antimeridian(Line{{-190, 0}, {-170, 2}}),
            (std::vector<Line>{{{170, 0}, {180, 1}}, {{-180, 1}, {-170, 2}}}));
}

}  // namespace
}  // namespace thiessen
