#include "basin/centroid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thiessen {
namespace {

const Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(PlaneCentroid, is_that_of_ground_without_its_holes) {
  EXPECT_EQ(plane_centroid({{square, {}}}), (Point{2, 2}));
  // 16 about (2, 2) less 4 about (1, 1): (32 - 4) / 12.
  const Point cut = plane_centroid({{square, {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}}});
  EXPECT_NEAR(cut.x, 28.0 / 12, 1e-15);
  EXPECT_NEAR(cut.y, 28.0 / 12, 1e-15);
  // 16 about (2, 2) and 1 about (10.5, 0.5).
  const Point both = plane_centroid({{square, {}}, {{{10, 0}, {10, 1}, {11, 1}, {11, 0}}, {}}});
  EXPECT_NEAR(both.x, (32 + 10.5) / 17, 1e-14);
  EXPECT_NEAR(both.y, (32 + 0.5) / 17, 1e-14);
}

TEST(PlaneCentroid, keeps_its_digits_far_from_the_origin) {
  const Point far = plane_centroid(
      {{{{500000, 5500000}, {500001, 5500000}, {500001, 5500001}, {500000, 5500001}}, {}}});
  EXPECT_EQ(far, (Point{500000.5, 5500000.5}));
}

TEST(PlaneCentroid, of_what_has_no_area_is_the_middle_of_its_corners) {
  EXPECT_EQ(plane_centroid({{{{0, 0}, {2, 2}}, {}}}), (Point{1, 1}));
}

TEST(SphereCentroid, of_symmetric_ground_is_its_middle) {
  const Point equator = sphere_centroid({{{{10, -5}, {20, -5}, {20, 5}, {10, 5}}, {}}});
  EXPECT_NEAR(equator.x, 15, 1e-12);
  EXPECT_NEAR(equator.y, 0, 1e-12);
  // The octant between 0 and 90 degrees: the direction (1, 1, 1).
  const Point octant = sphere_centroid({{{{0, 0}, {90, 0}, {90, 90}, {0, 90}}, {}}});
  EXPECT_NEAR(octant.x, 45, 1e-12);
  EXPECT_NEAR(octant.y, std::atan(std::sqrt(0.5)) * 180 / M_PI, 1e-12);
}

TEST(SphereCentroid, over_the_antimeridian_lies_on_either_side) {
  const Point centroid = sphere_centroid({{{{178, -1}, {186, -1}, {186, 1}, {178, 1}}, {}}});
  EXPECT_NEAR(centroid.x, -178, 1e-12);
  EXPECT_NEAR(centroid.y, 0, 1e-12);
}

TEST(SphereCentroid, of_a_small_basin_is_nearly_that_of_its_plane) {
  const Point small =
      sphere_centroid({{{{7.001, 47}, {7.0, 47}, {7.0, 47.001}, {7.001, 47.001}}, {}}});
  EXPECT_NEAR(small.x, 7.0005, 1e-8);
  EXPECT_NEAR(small.y, 47.0005, 1e-8);
}

TEST(SphereCentroid, of_the_whole_earth_is_the_middle_of_its_corners) {
  const Point all = sphere_centroid({{{{-180, -90},
                                       {-90, -90},
                                       {0, -90},
                                       {90, -90},
                                       {180, -90},
                                       {180, 90},
                                       {90, 90},
                                       {0, 90},
                                       {-90, 90},
                                       {-180, 90}},
                                      {}}});
  EXPECT_NEAR(all.x, 0, 1e-9);
  EXPECT_NEAR(all.y, 0, 1e-9);
}

}  // namespace
}  // namespace thiessen
