#include "files/basin_tracing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "outlines/ellipsoid_strip.h"
#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

const Crs& equal_area() {
  static const Crs crs = Crs::from_text("EPSG:6933", setting("basins_crs"));
  return crs;
}

// In an equal-area projection the plane's area is the Earth's, chords and bulges together.
TEST(BasinTracing, keeps_the_area_and_is_valid_at_any_tolerance) {
  for (const double tolerance : {0.1, 100.0}) {
    BasinTracing tracing(equal_area(), Crs::wgs84(), tolerance);
    MultiPolygon basin = {{{{0, 0}, {1e6, 3e6}, {0, 5e6}}, {}}};
    const auto traced = tracing.trace(basin);
    ASSERT_TRUE(traced);
    EXPECT_EQ(validity_fault(traced->shape), "");
    EXPECT_NEAR(area_on_earth(*traced) / 2.5e12, 1, 1e-9);
    EXPECT_EQ(tracing.collapsed(), 0);
    EXPECT_EQ(tracing.fault(), "");
    EXPECT_EQ(basin[0].outer.size(), 3U);
  }
}

TEST(BasinTracing, tells_where_a_basin_leaves_the_projection) {
  BasinTracing tracing(equal_area(), Crs::wgs84(), 0.1);
  const Point off{1e6, 9e6};  // the pole's northing is 7.3 million metres
  MultiPolygon basin = {{{{0, 0}, {1e6, 0}, off}, {}}};
  EXPECT_FALSE(tracing.trace(basin));
  EXPECT_EQ(tracing.fault(), "");
  EXPECT_GT(tracing.outside().y, 7.3e6);
  EXPECT_EQ(tracing.collapsed(), 0);
}

// A square of 10 km with a needle on its north side, which is so wide at its foot.
MultiPolygon with_needle(double width) {
  return {{{{4e5, 5.5e6},
            {4.1e5, 5.5e6},
            {4.1e5, 5.51e6},
            {4.05e5 + width, 5.51e6},
            {4.083e5, 5.5277e6},
            {4.05e5, 5.51e6},
            {4e5, 5.51e6}},
           {}}};
}

// A millionth of a metre stays; a billionth is less than degrees are rounded by, its sides cross,
// and it is collapsed.
TEST(BasinTracing, collapses_only_needles_that_rounding_makes_cross_themselves) {
  BasinTracing tracing(Crs::from_text("EPSG:32633", setting("basins_crs")), Crs::wgs84(), 0.1);
  MultiPolygon wide = with_needle(1e-6);
  EXPECT_TRUE(tracing.trace(wide));
  EXPECT_EQ(tracing.collapsed(), 0);
  EXPECT_EQ(wide[0].outer.size(), 7U);
  MultiPolygon narrow = with_needle(1e-9);
  const auto traced = tracing.trace(narrow);
  ASSERT_TRUE(traced);
  EXPECT_EQ(validity_fault(traced->shape), "");
  EXPECT_EQ(tracing.collapsed(), 1e-7);
  EXPECT_EQ(narrow[0].outer,
            (Ring{{4e5, 5.5e6}, {4.1e5, 5.5e6}, {4.1e5, 5.51e6}, {4.05e5, 5.51e6}, {4e5, 5.51e6}}));
  MultiPolygon again = with_needle(1e-6);
  EXPECT_TRUE(tracing.trace(again));
  EXPECT_EQ(tracing.collapsed(), 0) << "of the last basin alone";
}

// A sliver a metre wide between an edge and two that bend a little: chords within 250 m of each
// would cross. They are drawn finer, and no vertex of the basin is lost.
TEST(BasinTracing, draws_chords_finer_where_they_would_cross) {
  BasinTracing tracing(equal_area(), Crs::wgs84(), 1000);
  MultiPolygon basin = {{{{0, 4e6}, {60001, 4179999.5}, {200100, 4.6e6}, {200000, 4.6e6}}, {}}};
  const double area = plane_area(basin);
  const auto traced = tracing.trace(basin);
  ASSERT_TRUE(traced);
  EXPECT_EQ(validity_fault(traced->shape), "");
  EXPECT_EQ(tracing.collapsed(), 0);
  EXPECT_EQ(basin[0].outer.size(), 4U);
  EXPECT_GT(traced->shape[0].outer.size(), 100U);
  EXPECT_NEAR(area_on_earth(*traced) / area, 1, 1e-6);
}

TEST(BasinTracing, says_what_is_wrong_with_a_basin_that_crosses_itself_anyhow) {
  BasinTracing tracing(equal_area(), Crs::wgs84(), 0.1);
  MultiPolygon eight = {{{{0, 0}, {1e5, 1e5}, {1e5, 0}, {0, 2e5}}, {}}};
  EXPECT_FALSE(tracing.trace(eight));
  EXPECT_NE(tracing.fault().find("self-intersection"), std::string::npos) << tracing.fault();
}

TEST(PlaneMending, leaves_a_valid_shape_as_it_is) {
  MultiPolygon shape = {{{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}, {}}};
  const PlaneMending mending = make_valid_in_plane(shape);
  EXPECT_FALSE(mending.redrawn);
  EXPECT_EQ(mending.fault, "");
  EXPECT_EQ(shape[0].outer.size(), 4U);
}

TEST(PlaneMending, redraws_what_crosses_itself_in_a_hundred_thousandth_of_its_area) {
  // A lobe that runs the other way round, of a square metre.
  MultiPolygon shape = {{{{0, 0},
                          {1000, 0},
                          {1000, 1000},
                          {501, 1000},
                          {499, 1001},
                          {501, 1001},
                          {499, 1000},
                          {0, 1000}},
                         {}}};
  const double lobes = 1;
  const PlaneMending mending = make_valid_in_plane(shape);
  EXPECT_TRUE(mending.redrawn);
  EXPECT_EQ(mending.fault, "");
  EXPECT_EQ(validity_fault(shape), "");
  EXPECT_NEAR(plane_area(shape), 1e6, lobes);
}

TEST(PlaneMending, refuses_what_is_in_dispute_by_more) {
  MultiPolygon shape = {{{{0, 0}, {1000, 1000}, {1000, 0}, {0, 1000}}, {}}};
  const MultiPolygon before = shape;
  const PlaneMending mending = make_valid_in_plane(shape);
  EXPECT_FALSE(mending.redrawn);
  EXPECT_NE(mending.fault.find("self-intersection"), std::string::npos) << mending.fault;
  EXPECT_EQ(shape[0].outer, before[0].outer);
}

}  // namespace
}  // namespace thiessen
