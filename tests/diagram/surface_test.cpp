#include "diagram/surface.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

Point random_point(Seeded& seeded) {
  return {seeded.uniform(-1e6, 1e6), seeded.uniform(-1e6, 1e6)};
}

TEST(PlaneSurface, law_1_a_segment_back_has_the_area_with_the_other_sign_bit_for_bit) {
  Seeded seeded;
  const PlaneSurface plane(0.3048);
  for (std::uint64_t round = 0; round < Seeded::rounds(1000); ++round) {
    const Point a = random_point(seeded);
    const Point b = random_point(seeded);
    const double reference = seeded.uniform(-1e6, 1e6);
    EXPECT_EQ(plane.under(b, a, reference), -plane.under(a, b, reference));
  }
}

// Round a counter-clockwise ring it is minus the area: of a triangle by half its determinant.
TEST(PlaneSurface, law_2_the_sum_round_a_ring_is_minus_its_area_whatever_the_reference) {
  Seeded seeded;
  const PlaneSurface plane;
  for (std::uint64_t round = 0; round < Seeded::rounds(1000); ++round) {
    const std::vector<Point> ring{random_point(seeded), random_point(seeded), random_point(seeded)};
    const double area = ((ring[1].x - ring[0].x) * (ring[2].y - ring[0].y) -
                         (ring[1].y - ring[0].y) * (ring[2].x - ring[0].x)) /
                        2;
    for (const double reference : {0.0, -5e5, 1e6}) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += plane.under(ring[i], ring[(i + 1) % 3], reference);
      EXPECT_NEAR(sum, -area, 1e-2);  // of 1e12
    }
  }
}

// A trapezium of heights 1 and 3 over a width of 4, in feet.
TEST(PlaneSurface, law_3_areas_are_in_square_metres_of_the_unit) {
  EXPECT_EQ(PlaneSurface().under({2, 6}, {6, 8}, 5), 8);
  EXPECT_EQ(PlaneSurface(0.25).under({2, 6}, {6, 8}, 5), 2);
  EXPECT_EQ(PlaneSurface().under({2, 6}, {6, 8}, 9), -8);
  EXPECT_EQ(PlaneSurface().under({2, 6}, {2, 8}, 5), 0);
}

}  // namespace
}  // namespace thiessen
