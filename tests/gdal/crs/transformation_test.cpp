#include "gdal/crs/transformation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/complaints.h"

namespace thiessen {
namespace {

Crs crs(const std::string& text) {
  return Crs::from_text(text, setting("crs"));
}

TEST(Transformation, takes_east_before_north_whatever_the_authority_says) {
  // The false easting and the equator: the central meridian of zone 33 is 15 degrees east.
  const Transformation to_plane(crs("EPSG:4326"), crs("EPSG:32633"));
  const auto on_meridian = to_plane({15, 0});
  ASSERT_TRUE(on_meridian);
  EXPECT_NEAR(on_meridian->x, 500000, 1e-6);
  EXPECT_NEAR(on_meridian->y, 0, 1e-6);
  // Snyder, Map Projections (USGS 1395), p. 269: 40 30 N 73 30 W on Clarke 1866 is x = 627106.5 m,
  // y = 4484124.4 m in zone 18.
  const Transformation clarke(crs("+proj=longlat +ellps=clrk66 +no_defs"),
                              crs("+proj=utm +zone=18 +ellps=clrk66 +units=m +no_defs"));
  const auto snyder = clarke({-73.5, 40.5});
  ASSERT_TRUE(snyder);
  EXPECT_NEAR(snyder->x, 627106.5, 0.06);
  EXPECT_NEAR(snyder->y, 4484124.4, 0.06);
}

TEST(Transformation, knows_where_a_projection_ends) {
  const Transformation to_plane(crs("EPSG:4326"), crs("EPSG:32633"));
  EXPECT_FALSE(to_plane({-120, 40}));
  EXPECT_TRUE(to_plane({10, 50}));
  EXPECT_FALSE(Transformation(crs("EPSG:32633"), crs("EPSG:4326"))({1e9, 1e9}));
  std::vector<Point> points = {{10, 50}, {-120, 40}};
  EXPECT_EQ(to_plane.apply(points), (std::vector<bool>{true, false}));
  EXPECT_EQ(points[1], (Point{-120, 40}));
}

// On Mercator's cylinder a pole is infinitely far away; a polar plane has it at its middle.
TEST(Transformation, knows_poles_that_a_projection_tears_apart) {
  const Transformation cylinder(crs("EPSG:4326"), crs("EPSG:3857"));
  EXPECT_FALSE(cylinder({10.2, 90}));
  EXPECT_FALSE(cylinder({10.2, -90}));
  EXPECT_FALSE(cylinder({10.2, 89.9999}));
  EXPECT_TRUE(cylinder({10.2, 89}));
  EXPECT_TRUE(Transformation(crs("EPSG:4326"), crs("EPSG:3413"))({10.2, 90}));
  EXPECT_TRUE(Transformation(crs("EPSG:4326"), crs("EPSG:3031"))({10.2, -90}));
  EXPECT_FALSE(Transformation(crs("EPSG:4326"), crs("+proj=merc +ellps=WGS84"))({0, 90}));
}

TEST(Transformation, of_a_crs_to_itself_changes_no_bit) {
  const Transformation same(crs("EPSG:4326"), crs("OGC:CRS84"));
  EXPECT_TRUE(same.identity());
  EXPECT_EQ(same({0.1, -0.3}), (Point{0.1, -0.3}));
}

TEST(Transformation, tells_the_kinds_of_both_sides_and_the_operation_between_them) {
  const Transformation feet(crs("EPSG:4267"), crs("EPSG:2263"));
  EXPECT_TRUE(feet.from().in_degrees());
  EXPECT_FALSE(feet.to().geographic);
  EXPECT_DOUBLE_EQ(feet.to().metres_per_unit(), 1200.0 / 3937) << "US survey feet";
  ASSERT_NE(feet.choice(), nullptr);
  EXPECT_NE(feet.choice()->steps, "");
  EXPECT_EQ(Transformation(crs("EPSG:4326"), crs("EPSG:4326")).choice(), nullptr);
}

// Both zones are the ellipsoid of WGS 84: a quarter of a degree east of the one's meridian is as
// far from the meridian of the other on any way.
TEST(Transformation, law_1_over_degrees_or_straight_from_zone_to_zone_is_the_same) {
  const Transformation straight(crs("EPSG:32633"), crs("EPSG:32632"));
  const Transformation up(crs("EPSG:32633"), Crs::wgs84());
  const Transformation down(Crs::wgs84(), crs("EPSG:32632"));
  for (const Point at : {Point{500000, 5.5e6}, Point{450000, 6.1e6}, Point{520000, 1e5}}) {
    const Point one = straight(at).value();
    const Point other = down(up(at).value()).value();
    EXPECT_NEAR(one.x, other.x, 1e-6);
    EXPECT_NEAR(one.y, other.y, 1e-6);
  }
}

TEST(Transformation, law_2_forth_and_back_is_where_it_was) {
  const Transformation there(crs("EPSG:4314"), crs("EPSG:32632"));
  const Transformation back(crs("EPSG:32632"), crs("EPSG:4314"));
  for (const Point at : {Point{9, 51}, Point{7.1, 48.2}, Point{13.3, 54.4}}) {
    const Point returned = back(there(at).value()).value();
    EXPECT_NEAR(returned.x, at.x, 1e-12);
    EXPECT_NEAR(returned.y, at.y, 1e-12);
  }
}

TEST(Transformation, without_proof_takes_points_outside_its_area_too) {
  const Transformation to_plane(crs("EPSG:4326"), crs("EPSG:32633"));
  std::vector<Point> proved = {{15, 50}, {40, 50}};
  std::vector<Point> unproved = proved;
  EXPECT_EQ(to_plane.apply(proved), (std::vector<bool>{true, false}));
  to_plane.apply_unproved(unproved);
  EXPECT_EQ(proved[0], unproved[0]);
  EXPECT_EQ(proved[1], (Point{40, 50})) << "a point that is outside stays as it was";
  EXPECT_GT(unproved[1].x, 2e6);
}

// Bessel's ellipsoid without a datum: to a kilometre or so is all that is asked for.
TEST(RoughDegrees, are_had_of_any_datum_but_not_without_the_grid_that_a_crs_names) {
  std::vector<Point> points = {{500000, 5.5e6}};
  EXPECT_TRUE(take_roughly_to_degrees(crs("+proj=utm +zone=33 +ellps=bessel"), points));
  EXPECT_NEAR(points[0].x, 15, 0.01);
  EXPECT_NEAR(points[0].y, 49.65, 0.01);
  const std::vector<Point> before = {{15, 50}};
  points = before;
  EXPECT_FALSE(take_roughly_to_degrees(
      crs("+proj=longlat +ellps=clrk66 +nadgrids=no_such_grid.gsb"), points));
  EXPECT_EQ(points, before);
  EXPECT_TRUE(take_roughly_to_degrees(Crs::wgs84(), points));
  EXPECT_EQ(points, before);
}

}  // namespace
}  // namespace thiessen
