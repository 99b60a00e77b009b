#include "gdal/crs/shape_tracer.h"

#include <gtest/gtest.h>

#include "gdal/layers/geometry_conversion.h"
#include "outlines/ellipsoid_strip.h"
#include "outlines/polygon_validity.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

constexpr double half = 1e6;

Ring square(double x, double y, double side) {
  return {{x - side, y - side}, {x + side, y - side}, {x + side, y + side}, {x - side, y + side}};
}

/// In an equal-area projection about the north pole: the plane's areas are the Earth's (PROJ's
/// series for the authalic latitude leaves 1e-10).
struct Plane {
  Crs crs = Crs::from_text("EPSG:3571", setting("basins_crs"));
  ShapeTracer to_earth = tracer_between(crs, Crs::wgs84(), 0.02, Course::chords_and_bulges);
  ShapeTracer to_plane = tracer_between(Crs::wgs84(), crs, 0.02, Course::chords);

  CurvedShape on_earth(const MultiPolygon& shape) {
    auto traced = to_earth.trace(shape, Longitudes::run_on);
    EXPECT_TRUE(traced);
    EXPECT_EQ(validity_fault(traced->shape), "");
    return *std::move(traced);
  }
};

struct Case {
  const char* name;
  MultiPolygon shape;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

class Polar : public testing::TestWithParam<Case> {};

TEST_P(Polar, keeps_its_area_on_the_earth_and_back) {
  Plane plane;
  const double area = plane_area(GetParam().shape);
  const CurvedShape earth = plane.on_earth(GetParam().shape);
  EXPECT_NEAR(area_on_earth(earth) / area, 1, 3e-10);
  for (const CurvedShape& shape : {earth, [&] {
                                     CurvedShape cut = earth;
                                     cut_at_antimeridian(cut);
                                     return cut;
                                   }()}) {
    EXPECT_NEAR(area_on_earth(shape) / area, 1, 3e-10);
    EXPECT_EQ(validity_fault(shape.shape), "");
    const auto back = plane.to_plane.trace(shape.shape, Longitudes::run_on);
    ASSERT_TRUE(back);
    EXPECT_EQ(validity_fault(back->shape), "");
    // One part, as it was: joined at the antimeridian and at the pole.
    EXPECT_EQ(back->shape.size(), GetParam().shape.size());
    EXPECT_NEAR(plane_area(back->shape) / area, 1, 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(
    ShapeTracing, Polar,
    testing::Values(
        Case{"round_the_pole", {{square(3e5, -2e5, half), {}}}},
        Case{"past_the_pole_by_a_millimetre", {{square(half - 0.001, 0, half), {}}}},
        Case{"annulus", {{square(1e5, 0, half), {square(0, 5e4, 3e5)}}}},
        Case{"vertex_at_the_pole", {{{{0, 0}, {half, -half}, {half, half}}, {}}}},
        Case{"three_quarters_round_it",
             {{{{0, 0}, {0, half}, {-half, half}, {-half, -half}, {half, -half}, {half, 0}}, {}}}},
        Case{"edge_through_the_pole",
             {{{{0, -half}, {0, half}, {-half, half}, {-half, -half}}, {}}}},
        Case{"edge_along_the_antimeridian_to_the_pole",
             {{{{-7e5, -4e5}, {7e5, -4e5}, {7e5, 4e5}}, {}}}},
        Case{"hole_with_a_vertex_at_the_pole",
             {{square(0, 0, half), {{{0, 0}, {3e5, -1e5}, {3e5, 1e5}}}}}},
        Case{"on_the_antimeridian", {{square(0, 1.2e6, 5e5), {}}}},
        Case{"parts_that_meet_at_the_pole",
             {{{{0, 0}, {half, -half}, {half, half}}, {}},
              {{{0, 0}, {-half, half}, {-half, -half}}, {}}}}),
    name_of);

TEST(ShapeTracing, a_ring_that_holds_both_poles_leaves_a_hole_where_it_is_not) {
  const Crs plane = Crs::from_text("+proj=laea +lat_0=0 +lon_0=100", setting("basins_crs"));
  ShapeTracer tracer = tracer_between(plane, Crs::wgs84(), 0.02, Course::chords_and_bulges);
  // The poles lie 9 million metres off, and the far side 12.7.
  Ring circle;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / 64;
    circle.push_back({11.5e6 * std::cos(angle), 11.5e6 * std::sin(angle)});
  }
  const MultiPolygon wide = {{circle, {}}};
  const auto earth = tracer.trace(wide, Longitudes::run_on);
  ASSERT_TRUE(earth);
  ASSERT_EQ(earth->shape.size(), 1U);
  EXPECT_EQ(earth->shape[0].holes.size(), 1U);
  EXPECT_NEAR(area_on_earth(*earth) / plane_area(wide), 1, 3e-10);
}

TEST(ShapeTracing, round_the_earth_in_a_cylinder_is_a_band) {
  const Crs plane = Crs::from_text("EPSG:6933", setting("basins_crs"));
  ShapeTracer tracer = tracer_between(plane, Crs::wgs84(), 0.02, Course::chords_and_bulges);
  const Ring band = {
      {-17367530.44, 6e6}, {17367530.44, 6e6}, {17367530.44, 7e6}, {-17367530.44, 7e6}};
  const auto earth = tracer.trace({{band, {}}}, Longitudes::run_on);
  ASSERT_TRUE(earth);
  EXPECT_NEAR(area_on_earth(*earth) / (2 * 17367530.44 * 1e6), 1, 3e-10);
}

TEST(ShapeTracing, a_projection_torn_at_the_antimeridian_keeps_both_sides) {
  ShapeTracer tracer = tracer_between(
      Crs::wgs84(), Crs::from_text("EPSG:3857", setting("basins_crs")), 0.02, Course::chords);
  const auto torn =
      tracer.trace({{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {}}}, Longitudes::run_on);
  ASSERT_TRUE(torn);
  ASSERT_EQ(torn->shape.size(), 2U);
  // Twice 10 degrees of the equator times y(10 degrees) = R ln tan 50.
  const double r = 6378137;
  const double degree = std::acos(-1.0) / 180;
  EXPECT_NEAR(plane_area(torn->shape) / (2 * 10 * degree * r * r * std::log(std::tan(50 * degree))),
              1, 1e-9);
}

TEST(ShapeTracing, a_pole_out_of_the_projections_reach_is_told) {
  ShapeTracer tracer = tracer_between(Crs::wgs84(), Crs::from_text("EPSG:3857", setting("plane")),
                                      1e5, Course::ends);
  EXPECT_FALSE(tracer.trace({{{{-180, 60}, {0, 60}, {180, 60}, {180, 90}, {-180, 90}}, {}}},
                            Longitudes::run_on));
  EXPECT_EQ(tracer.outside(), (Point{0, 90}));
}

TEST(ShapeTracing, takes_vertices_alone_where_that_is_wanted) {
  Plane plane;
  ShapeTracer tracer = tracer_between(Crs::wgs84(), plane.crs, 1e5, Course::ends);
  const auto cap = tracer.trace(
      {{{{-180, 60}, {-90, 60}, {0, 60}, {90, 60}, {180, 60}, {180, 90}, {-180, 90}}, {}}},
      Longitudes::run_on);
  ASSERT_TRUE(cap);
  ASSERT_EQ(cap->shape.size(), 1U);
  EXPECT_EQ(cap->shape[0].outer.size(), 4U);
}

}  // namespace
}  // namespace thiessen
