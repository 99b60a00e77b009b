// Edges that span more than 180 degrees of longitude.
#include "outlines/wide_edges.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

struct Read {
  WideEdges wide;
  Ring ring;
  int winding;
};

Read read(const Ring& ring) {
  WideEdges wide;
  const WindingRing meant = ring_as_meant(ring, wide);
  return {wide, unwrapped(meant), meant.winding};
}

TEST(WideEdges, up_to_180_degrees_go_as_written) {
  const Ring ring = {{-90, 0}, {90, 0}, {90, 10}, {-90, 10}};
  const Read found = read(ring);
  EXPECT_EQ(found.ring, ring);
  EXPECT_EQ(found.wide.fault(), "");
  EXPECT_TRUE(found.wide.assumptions().empty());
}

TEST(WideEdges, beyond_180_and_up_to_270_are_unclear) {
  EXPECT_EQ(
      read({{-10, 0}, {180, 0}, {180, 80}, {-10, 80}}).wide.fault(),
      "the edge from -10 0 to 180 0 (and 1 more) spans 190 degrees of longitude: which way it "
      "goes is not known");
  EXPECT_EQ(read({{-135, 0}, {135, 0}, {0, 9}}).wide.unclear.size(), 1U);
  EXPECT_TRUE(read({{-135.1, 0}, {135, 0}, {0, 9}}).wide.unclear.empty());
  // More than a turn, and then which way is not known either.
  EXPECT_EQ(read({{-180, 0}, {360, 0}, {0, 9}}).wide.unclear.size(), 1U);
}

TEST(WideEdges, beyond_270_go_over_the_antimeridian) {
  const Read found = read({{170, 0}, {-170, 0}, {-170, 10}, {170, 10}});
  EXPECT_EQ(found.ring, (Ring{{170, 0}, {190, 0}, {190, 10}, {170, 10}}));
  ASSERT_EQ(found.wide.assumptions().size(), 1U);
  EXPECT_EQ(
      found.wide.assumptions()[0],
      "the edge from 170 0 to -170 0 (and 1 more) spans 340 degrees of longitude and is taken "
      "the short way, over the antimeridian");
}

TEST(WideEdges, in_longitudes_to_360_the_short_way_is_over_greenwich) {
  const Read found = read({{350, 0}, {10, 0}, {10, 9}, {350, 9}});
  EXPECT_EQ(found.ring, (Ring{{350, 0}, {370, 0}, {370, 9}, {350, 9}}));
  EXPECT_EQ(found.wide.assumptions().at(0),
            "the edge from 350 0 to 10 0 (and 1 more) spans 340 degrees of longitude and is taken "
            "the short way");
}

TEST(WideEdges, a_band_of_four_corners_has_whole_parallels_in_quarters) {
  for (const double west : {-180.0, 0.0}) {
    const Read found = read({{west, -60}, {west + 360, -60}, {west + 360, 60}, {west, 60}});
    EXPECT_EQ(found.winding, 0);
    EXPECT_EQ(found.wide.circles.size(), 2U);
    ASSERT_EQ(found.ring.size(), 10U);
    for (std::size_t k = 0; k <= 4; ++k)
      EXPECT_EQ(found.ring[k].x, found.ring[0].x + 90 * static_cast<double>(k));
    EXPECT_EQ(found.ring[9].x, found.ring[0].x);
  }
}

TEST(WideEdges, a_cap_of_four_corners_has_a_whole_parallel) {
  for (const double pole : {-90.0, 90.0}) {
    const Read found = read({{-180, 60}, {180, 60}, {180, pole}, {-180, pole}});
    EXPECT_EQ(found.winding, 0);
    EXPECT_EQ(found.wide.circles.size(), 1U);
    EXPECT_EQ(found.ring[4].x - found.ring[0].x, 360);
    EXPECT_EQ(found.wide.assumptions().at(0),
              "the edge from -180 60 to 180 60 is taken as the whole parallel");
  }
}

TEST(WideEdges, a_ring_closed_over_the_antimeridian_has_one_point_there) {
  const Read found = read({{-180, 60}, {-60, 60}, {60, 60}, {180, 60}});
  EXPECT_EQ(found.winding, 1);
  EXPECT_EQ(found.wide.one_point.size(), 1U);
  // The same where a ring only touches it.
  const Read fiji = read({{180, -16}, {-180, -16}, {-179, -17}, {179, -17}});
  EXPECT_EQ(fiji.winding, 0);
  EXPECT_EQ(fiji.ring, (Ring{{180, -16}, {180, -16}, {181, -17}, {179, -17}}));
}

TEST(WideEdges, along_a_pole_no_edge_has_a_length) {
  const Read earth = read({{-180, -90}, {180, -90}, {180, 90}, {-180, 90}});
  EXPECT_TRUE(earth.wide.assumptions().empty());
  const Read sector = read({{-110, 60}, {0, 60}, {110, 60}, {110, 90}, {-110, 90}});
  EXPECT_EQ(sector.wide.fault(), "");
  EXPECT_TRUE(sector.wide.assumptions().empty());
}

}  // namespace
}  // namespace thiessen
