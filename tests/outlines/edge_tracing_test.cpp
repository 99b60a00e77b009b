#include "outlines/edge_tracing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "earth/area/ellipsoid_area.h"
#include "outlines/sphere_mercator.h"

namespace thiessen {
namespace {

constexpr double chord_error = 10;  // metres

/// How far the parallel-free line from a to b, straight in degrees, lies from the chords in the
/// plane, at its points of these shares.
double farthest_from_chords(Point a, Point b, const std::vector<Point>& chords) {
  double farthest = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double share = i / 1000.0;
    const Point on = SphereMercator::plane({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < chords.size(); ++k) {
      const Point p = chords[k];
      const Point q = chords[k + 1];
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      const double along = std::clamp(
          ((on.x - p.x) * (q.x - p.x) + (on.y - p.y) * (q.y - p.y)) / length / length, 0.0, 1.0);
      nearest = std::min(
          nearest, std::hypot(on.x - p.x - along * (q.x - p.x), on.y - p.y - along * (q.y - p.y)));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

std::vector<Point> without(const Ring& ring, std::size_t first, Point last) {
  const auto end = std::find(ring.begin(), ring.end(), last);
  return {ring.begin() + static_cast<std::ptrdiff_t>(first), end + 1};
}

TEST(EdgeTracer, every_chord_lies_within_its_error_of_the_true_edge) {
  const ToMercator mapping;
  EdgeTracer tracer(mapping, {}, chord_error, Course::chords);
  const Point a{10, 40};
  const Point b{24, 61};
  const Point c{10, 61};
  const auto traced = tracer.trace(Ring{a, b, c});
  ASSERT_TRUE(traced);
  const std::vector<Point> chords = without(traced->points, 0, SphereMercator::plane(b));
  EXPECT_GT(chords.size(), 10U);
  EXPECT_LE(farthest_from_chords(a, b, chords), chord_error);
}

TEST(EdgeTracer, a_looser_error_takes_fewer_chords) {
  const ToMercator mapping;
  const Ring ring = {{10, 40}, {24, 61}, {10, 61}};
  const auto points = [&](double error) {
    return EdgeTracer(mapping, {}, error, Course::chords).trace(ring).value().points.size();
  };
  EXPECT_LT(points(1000), points(10));
  EXPECT_LT(points(10), points(0.1));
}

TEST(EdgeTracer, two_rings_cut_a_shared_edge_at_the_same_points_whichever_way_they_run) {
  const ToMercator mapping;
  EdgeTracer tracer(mapping, {}, chord_error, Course::chords);
  const Point a{10, 40};
  const Point b{24, 61};
  const Ring there = tracer.trace(Ring{a, b, {0, 61}}).value().points;
  const Ring back = tracer.trace(Ring{b, a, {40, 40}}).value().points;
  std::vector<Point> forth = without(there, 0, SphereMercator::plane(b));
  const std::vector<Point> reversed = without(back, 0, SphereMercator::plane(a));
  std::reverse(forth.begin(), forth.end());
  EXPECT_EQ(forth, reversed);
}

TEST(EdgeTracer, ends_alone_keep_the_vertices_and_no_more) {
  const ToMercator mapping;
  const Ring ring = {{10, 40}, {24, 61}, {10, 61}};
  const auto traced = EdgeTracer(mapping, {}, 1e5, Course::ends).trace(ring);
  ASSERT_TRUE(traced);
  Ring wanted;
  for (const Point point : ring) wanted.push_back(SphereMercator::plane(point));
  EXPECT_EQ(traced->points, wanted);
}

TEST(EdgeTracer, a_vertex_outside_the_mappings_area_is_told) {
  const ToMercator mapping;
  EdgeTracer tracer(mapping, {}, chord_error, Course::chords);
  EXPECT_FALSE(tracer.trace(Ring{{0, 0}, {10, 0}, {5, 89}}));
  EXPECT_EQ(tracer.outside(), (Point{5, 89}));
}

// A straight edge of the plane from the equator to 60 degrees: what its chord in degrees cuts off
// is the area between both, which shrinks with the chords. The sum over the chords and the area of
// the ring through the vertices must not depend on how finely the edge is cut.
TEST(EdgeTracer, bulges_and_chords_together_do_not_depend_on_the_chord_error) {
  const FromMercator mapping;
  const Ring ring = {SphereMercator::plane({0, 0}), SphereMercator::plane({20, 0}),
                     SphereMercator::plane({20, 60})};
  const auto sum = [&](double error) {
    const WindingRing traced =
        EdgeTracer(mapping, {}, error, Course::chords_and_bulges).trace(ring).value();
    double area = 0;
    for (std::size_t i = 0; i < traced.points.size(); ++i) {
      area -= area_under(traced.points[i], traced.points[(i + 1) % traced.points.size()], 0);
      area += traced.bulges[i];
    }
    return area;
  };
  const double fine = sum(0.01);
  EXPECT_GT(fine, 1e12);
  EXPECT_NEAR(sum(10) / fine, 1, 1e-9);
  EXPECT_NEAR(sum(1000) / fine, 1, 1e-7);
}

TEST(EdgeTracer, edges_are_traced_each_for_itself) {
  const ToMercator mapping;
  EdgeTracer tracer(mapping, {}, 1e5, Course::ends);
  const auto traced = tracer.trace(std::vector<DirectedEdge>{{{0, 0}, {1, 1}}, {{5, 5}, {6, 4}}});
  ASSERT_TRUE(traced);
  ASSERT_EQ(traced->size(), 2U);
  const Point to = SphereMercator::plane({6, 4});
  EXPECT_NEAR((*traced)[1].to.x, to.x, 1e-6);
  EXPECT_NEAR((*traced)[1].to.y, to.y, 1e-6);
}

}  // namespace
}  // namespace thiessen
