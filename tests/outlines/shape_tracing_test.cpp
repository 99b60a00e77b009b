#include "outlines/shape_tracing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "outlines/ellipsoid_strip.h"
#include "outlines/polygon_validity.h"
#include "outlines/ring_direction.h"
#include "outlines/sphere_mercator.h"

namespace thiessen {
namespace {

/// The plane about the north pole in which distances from it are true: a degree of latitude is
/// 100 km, longitude 0 runs down and 90 to the right. It reaches to 30 degrees south.
class AboutThePole : public Mapping {
 public:
  static constexpr double metres = 1e5;  // a degree of latitude
  CoordinateKind from() const override { return {true, 1}; }
  CoordinateKind to() const override { return {false, 1}; }
  bool identity() const override { return false; }
  std::vector<bool> apply(std::vector<Point>& points) const override {
    std::vector<bool> inside;
    for (Point& point : points) {
      inside.push_back(point.y >= -30 && point.y <= 90);
      if (inside.back()) point = plane(point);
    }
    return inside;
  }
  void apply_unproved(std::vector<Point>& points) const override {
    for (Point& point : points) point = plane(point);
  }
  static Point plane(Point degrees) {
    const double out = (90 - degrees.y) * metres;
    // Sines and cosines of multiples of 45 degrees are exact enough, and the same for -180 and 180.
    const double turn = std::remainder(degrees.x, 360) * std::numbers::pi / 180;
    if (std::abs(std::remainder(degrees.x, 360)) == 180) return {0, out};
    return {out * std::sin(turn), -out * std::cos(turn)};
  }
};

/// Mercator's plane seen in a mirror, to degrees: eastings run west.
class FromMirroredMercator : public FromMercator {
 public:
  void apply_unproved(std::vector<Point>& points) const override {
    for (Point& point : points) point = SphereMercator::degrees({-point.x, point.y});
  }
};

template <typename Map>
ShapeTracer tracer_by(double chord_error, Course course) {
  return {std::make_shared<Map>(), {}, chord_error, course};
}

Ring mercator_ring(const Ring& degrees) {
  Ring ring;
  for (const Point p : degrees) ring.push_back(SphereMercator::plane(p));
  return ring;
}

// The edges of this square run along meridians and parallels, so the ellipsoid between two of each
// is what it holds, chords and bulges or not.
TEST(ShapeTracer, takes_a_shape_to_degrees_and_keeps_its_hole) {
  ShapeTracer tracer = tracer_by<FromMercator>(10, Course::chords_and_bulges);
  const MultiPolygon shape = {{mercator_ring({{10, 40}, {30, 40}, {30, 60}, {10, 60}}),
                               {mercator_ring({{15, 50}, {15, 55}, {20, 55}, {20, 50}})}}};
  const auto traced = tracer.trace(shape, Longitudes::run_on);
  ASSERT_TRUE(traced);
  ASSERT_EQ(traced->shape.size(), 1U);
  ASSERT_EQ(traced->shape[0].holes.size(), 1U);
  EXPECT_GT(signed_area(traced->shape[0].outer), 0);
  EXPECT_LT(signed_area(traced->shape[0].holes[0]), 0);
  EXPECT_NEAR(area_on_earth(*traced) / (strip_area(40, 60, 20) - strip_area(50, 55, 5)), 1, 1e-9);
}

// A mirror turns every ring over; what it traces is the mirror's image, bulges and all.
TEST(ShapeTracer, law_1_outer_rings_run_counter_clockwise_whichever_way_the_mapping_turns_them) {
  const Ring ring = {SphereMercator::plane({0, 0}), SphereMercator::plane({20, 0}),
                     SphereMercator::plane({20, 60})};
  const auto straight = tracer_by<FromMercator>(1000, Course::chords_and_bulges)
                            .trace({{ring, {}}}, Longitudes::run_on);
  const auto mirrored = tracer_by<FromMirroredMercator>(1000, Course::chords_and_bulges)
                            .trace({{ring, {}}}, Longitudes::run_on);
  ASSERT_TRUE(straight && mirrored);
  EXPECT_GT(signed_area(mirrored->shape[0].outer), 0);
  EXPECT_NEAR(area_on_earth(*mirrored) / area_on_earth(*straight), 1, 1e-12);
  EXPECT_LT(mirrored->shape[0].outer[1].x, 0);
}

TEST(ShapeTracer, longitudes_run_on_over_the_antimeridian_or_are_cut_there) {
  ShapeTracer tracer = tracer_by<FromMercator>(10, Course::ends);
  const MultiPolygon shape = {{mercator_ring({{170, 0}, {200, 0}, {200, 30}, {170, 30}}), {}}};
  const auto whole = tracer.trace(shape, Longitudes::run_on);
  ASSERT_TRUE(whole);
  ASSERT_EQ(whole->shape.size(), 1U);
  EXPECT_NEAR(plane_area(whole->shape), 900, 1e-9);
  const auto cut = tracer.trace(shape, Longitudes::cut);
  ASSERT_TRUE(cut);
  ASSERT_EQ(cut->shape.size(), 2U);
  EXPECT_NEAR(plane_area(cut->shape), 900, 1e-9);
  for (const Polygon& part : cut->shape) {
    for (const Point p : part.outer) EXPECT_LE(std::abs(p.x), 180);
  }
}

// Two halves of a sector from 150 to 210 degrees and from 60 to 80 north: with edges straight from
// corner to corner it is a quadrilateral of the plane, with areas r^2/2 sin 60 less the inner one.
const MultiPolygon two_halves = {{{{150, 60}, {180, 60}, {180, 80}, {150, 80}}, {}},
                                 {{{-180, 60}, {-150, 60}, {-150, 80}, {-180, 80}}, {}}};
double sector(double outer, double inner) {
  const double quarter = std::sin(std::numbers::pi / 6) / 2;  // two triangles of 30 degrees
  return 2 * quarter * (outer * outer - inner * inner);
}

TEST(ShapeTracer, joins_at_the_antimeridian_what_was_cut_there) {
  ShapeTracer tracer = tracer_by<AboutThePole>(1e6, Course::ends);
  const auto joined = tracer.trace(two_halves, Longitudes::run_on);
  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->shape.size(), 1U);
  EXPECT_EQ(joined->shape[0].outer.size(), 6U) << "with what was cut into the sides";
  EXPECT_GT(signed_area(joined->shape[0].outer), 0);
  EXPECT_NEAR(plane_area(joined->shape) / sector(3e6, 1e6), 1, 1e-12);
  const MultiPolygon runs_on = {
      {{{150, 60}, {180, 60}, {210, 60}, {210, 80}, {180, 80}, {150, 80}}, {}}};
  const auto same = tracer.trace(runs_on, Longitudes::run_on);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->shape.size(), 1U);
  EXPECT_NEAR(plane_area(same->shape) / sector(3e6, 1e6), 1, 1e-12);
}

TEST(ShapeTracer, leaves_out_the_vertices_of_a_cut_but_keeps_the_shapes_own) {
  ShapeTracer tracer = tracer_by<AboutThePole>(1e6, Course::ends);
  const auto none = tracer.trace_without_cuts(two_halves, {});
  ASSERT_TRUE(none);
  EXPECT_EQ(none->shape[0].outer.size(), 4U);
  const auto one = tracer.trace_without_cuts(two_halves, {60});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->shape[0].outer.size(), 5U);
  const Point own = AboutThePole::plane({180, 60});
  EXPECT_NE(std::find(one->shape[0].outer.begin(), one->shape[0].outer.end(), own),
            one->shape[0].outer.end());
}

// A cap in degrees is cut along the antimeridian and along the pole, where one point is many.
TEST(ShapeTracer, a_pole_within_a_shape_leaves_no_seam) {
  ShapeTracer tracer = tracer_by<AboutThePole>(1e6, Course::ends);
  const auto cap = tracer.trace(
      {{{{-180, 60}, {-90, 60}, {0, 60}, {90, 60}, {180, 60}, {180, 90}, {-180, 90}}, {}}},
      Longitudes::run_on);
  ASSERT_TRUE(cap);
  ASSERT_EQ(cap->shape.size(), 1U);
  EXPECT_EQ(cap->shape[0].outer.size(), 4U);
  EXPECT_NEAR(plane_area(cap->shape) / (2 * 3e6 * 3e6), 1, 1e-12);
}

TEST(ShapeTracer, a_mapping_torn_at_the_antimeridian_keeps_both_sides) {
  ShapeTracer tracer = tracer_by<ToMercator>(1e6, Course::ends);
  const auto torn =
      tracer.trace({{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {}}}, Longitudes::run_on);
  ASSERT_TRUE(torn);
  EXPECT_EQ(torn->shape.size(), 2U);
  const Point corner = SphereMercator::plane({20, 10});
  EXPECT_NEAR(plane_area(torn->shape) / (corner.x * corner.y), 1, 1e-12);
}

TEST(ShapeTracer, tells_where_a_shape_leaves_the_mappings_area) {
  ShapeTracer mercator = tracer_by<ToMercator>(1e6, Course::ends);
  EXPECT_FALSE(mercator.trace({{{{0, 0}, {10, 0}, {5, 89}}, {}}}, Longitudes::run_on));
  EXPECT_EQ(mercator.outside(), (Point{5, 89}));
  const MultiPolygon with_bad_hole = {
      {{{0, 0}, {20, 0}, {20, 80}, {0, 80}}, {{{5, 5}, {5, 6}, {6, 86}}}}};
  EXPECT_FALSE(mercator.trace(with_bad_hole, Longitudes::run_on));
  EXPECT_EQ(mercator.outside(), (Point{6, 86}));
  // Mercator has no pole.
  EXPECT_FALSE(mercator.trace({{{{-180, 60}, {0, 60}, {180, 60}, {180, 90}, {-180, 90}}, {}}},
                              Longitudes::run_on));
  EXPECT_EQ(mercator.outside(), (Point{0, 90}));
}

}  // namespace
}  // namespace thiessen
