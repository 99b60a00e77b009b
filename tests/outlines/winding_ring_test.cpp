#include "outlines/winding_ring.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(WindingRing, goes_the_short_way_and_counts_its_turns) {
  const WindingRing ring = ring_the_short_way({{0, 80}, {90, 80}, {180, 80}, {-90, 80}});
  EXPECT_EQ(ring.winding, 1);
  EXPECT_EQ(unwrapped(ring), (Ring{{0, 80}, {90, 80}, {180, 80}, {270, 80}}));
  EXPECT_EQ(ring.at(4), (Point{360, 80}));
  EXPECT_EQ(ring_the_short_way({{170, 0}, {-170, 0}, {180, 9}}).winding, 0);
  EXPECT_EQ(ring_the_short_way({{0, 9}, {-120, 9}, {120, 9}}).winding, -1);
}

TEST(WindingRing, holds_longitudes_beyond_180_as_turns) {
  const WindingRing ring = ring_the_short_way({{350, 0}, {360, 0}, {365, 5}});
  EXPECT_EQ(ring.points, (Ring{{-10, 0}, {0, 0}, {5, 5}}));
  EXPECT_EQ(unwrapped(ring), (Ring{{350, 0}, {360, 0}, {365, 5}}));
}

TEST(WindingRing, keeps_its_first_point_and_its_bulges_when_reversed) {
  WindingRing ring = ring_the_short_way({{0, 80}, {120, 70}, {-120, 60}});
  ring.bulges = {1, 2, 3};
  const WindingRing back = reversed(ring);
  EXPECT_EQ(back.winding, -1);
  EXPECT_EQ(unwrapped(back), (Ring{{0, 80}, {-120, 60}, {-240, 70}}));
  EXPECT_EQ(back.bulges, (std::vector<double>{-3, -2, -1}));
}

TEST(WindingRing, weighs_latitudes_by_the_longitude_gained) {
  // 80 for a quarter turn, 85 on average for nothing (out and back), -20 for the rest.
  const Ring ring = {{0, 80}, {90, 80}, {90, -20}, {180, -20}, {-90, -20}, {0, -20}};
  EXPECT_DOUBLE_EQ(mean_latitude(ring_the_short_way(ring)), (80 - 3 * 20) / 4.0);
  EXPECT_DOUBLE_EQ(mean_latitude(reversed(ring_the_short_way(ring))), (80 - 3 * 20) / 4.0);
}

TEST(WindingRing, goes_all_round_along_a_pole_in_steps_of_any_size) {
  for (const Ring& top : {Ring{{180, 90}, {-180, 90}}, Ring{{180, 90}, {-10, 90}, {-180, 90}},
                          Ring{{180, 90}, {60, 90}, {-60, 90}, {-180, 90}}}) {
    Ring ring = {{-180, 60}, {-60, 60}, {60, 60}, {180, 60}};
    ring.insert(ring.end(), top.begin(), top.end());
    EXPECT_EQ(ring_the_short_way(ring).winding, 0);
    EXPECT_EQ(unwrapped(ring_the_short_way(ring)), ring);
  }
}

TEST(WindingRing, is_led_back_along_the_pole_from_where_it_comes_to_where_it_goes) {
  WindingRing touching =
      ring_the_short_way({{-180, 60}, {-60, 60}, {60, 60}, {180, 60}, {180, 90}});
  ASSERT_EQ(touching.winding, 1);
  ASSERT_TRUE(lead_back_along(90, touching));
  EXPECT_EQ(touching.winding, 0);
  EXPECT_EQ(unwrapped(touching),
            (Ring{{180, 90}, {-180, 90}, {-180, 60}, {-60, 60}, {60, 60}, {180, 60}}));
  // Three quarters of a cap, with a step along the pole in between.
  WindingRing wedge =
      ring_the_short_way({{-180, 60}, {-60, 60}, {90, 60}, {90, 90}, {100, 90}, {-180, 90}});
  ASSERT_EQ(wedge.winding, 1);
  ASSERT_TRUE(lead_back_along(90, wedge));
  EXPECT_EQ(unwrapped(wedge), (Ring{{90, 90}, {-180, 90}, {-180, 60}, {-60, 60}, {90, 60}}));
  WindingRing elsewhere = ring_the_short_way({{0, 80}, {120, 70}, {-120, 60}});
  EXPECT_FALSE(lead_back_along(90, elsewhere));
}

}  // namespace
}  // namespace thiessen
