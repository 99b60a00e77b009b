#include "outlines/plane_poles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace thiessen {
namespace {

/// The polar stereographic projection of a unit sphere, in closed form: the north pole is at the
/// origin, and the south pole nowhere.
class ToPolarPlane : public Mapping {
 public:
  CoordinateKind from() const override { return {true, 1}; }
  CoordinateKind to() const override { return {false, 1}; }
  bool identity() const override { return false; }
  std::vector<bool> apply(std::vector<Point>& points) const override {
    std::vector<bool> inside;
    for (Point& point : points) {
      inside.push_back(point.y > -80);
      if (inside.back()) point = plane(point);
    }
    return inside;
  }
  void apply_unproved(std::vector<Point>& points) const override {
    for (Point& point : points) point = plane(point);
  }

 private:
  static Point plane(Point degrees) {
    const double radian = std::numbers::pi / 180;
    const double radius = 2 * std::tan((90 - degrees.y) / 2 * radian);
    return {radius * std::sin(degrees.x * radian), -radius * std::cos(degrees.x * radian)};
  }
};

TEST(PlanePoles, finds_those_that_the_projection_reaches) {
  const PlanePoles poles{ToPolarPlane()};
  ASSERT_EQ(poles.all().size(), 1U);
  EXPECT_EQ(poles.all()[0].latitude, 90);
  EXPECT_NEAR(std::hypot(poles.all()[0].at.x, poles.all()[0].at.y), 0, 1e-9);
  EXPECT_TRUE(poles.any_within(1, {0.5, 0.5}));
  EXPECT_FALSE(poles.any_within(1, {2, 0}));
}

TEST(PlanePoles, an_edge_over_a_pole_gets_a_node_there) {
  const PlanePoles poles{ToPolarPlane()};
  const auto nodes = poles.nodes_of({{-1, 0}, {1, 0}, {0, 1}});
  ASSERT_EQ(nodes.size(), 4U);
  EXPECT_EQ(nodes[1].pole, 90);
  EXPECT_EQ(nodes[2].at, (Point{1, 0}));
}

TEST(PlanePoles, a_vertex_at_a_pole_is_one_node_at_it) {
  const PlanePoles poles{ToPolarPlane()};
  const auto nodes = poles.nodes_of({{0, 0}, {1e-9, 0}, {1, 0}, {0, 1}});
  ASSERT_EQ(nodes.size(), 3U);
  EXPECT_EQ(nodes[0].pole, 90);
  EXPECT_EQ(nodes[1].pole, 0);
}

TEST(PlanePoles, of_no_plane_there_are_none_and_every_vertex_is_a_node) {
  const PlanePoles none;
  EXPECT_TRUE(none.all().empty());
  EXPECT_EQ(none.nodes_of({{0, 0}, {1, 0}, {0, 1}}).size(), 3U);
}

}  // namespace
}  // namespace thiessen
