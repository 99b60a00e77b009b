// Edges drawn as chords: judged by the distances of the two places whose cells they part.
#include "earth/cells/edge_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/units.h"

namespace thiessen {
namespace {

constexpr double accuracy = 1e-6;
constexpr PlaceIndex first{0};
constexpr PlaceIndex second{1};

Box box(Point low, Point high) {
  return {low, high};
}

GeodesicBisector edge_between(Point a, Point b) {
  const EarthPoint from(a);
  const EarthPoint to(b);
  return {from, to, {from.direction, to.direction}, accuracy};
}

/// The edge between the cells of two places, from one angle to another, in a diagram of its own.
Diagram drawn(Point a, Point b, const Box& frame, double tolerance, double from, double to) {
  const GeodesicBisector edge = edge_between(a, b);
  const LongitudeTurn longitudes(frame);
  Diagram diagram;
  for (const double angle : {from, to})
    diagram.nodes.push_back(longitudes.within(edge.find(angle).position));
  EdgeDrawing drawing(frame, tolerance, 2);
  drawing.draw(edge, {from, 0, diagram.nodes[0]}, {to, 1, diagram.nodes[1]}, first, second);
  drawing.add_to(diagram);
  return diagram;
}

// It may say yes in vain, but a no is certain.
TEST(MayComeNear, law_1_is_said_of_every_disc_that_has_a_point_in_the_frame) {
  Seeded seeded;
  for (std::uint64_t i = 0; i < Seeded::rounds(3000); ++i) {
    const Point low{seeded.uniform(-180, 180), seeded.uniform(-89, 80)};
    const Box frame = box(low, {low.x + seeded.uniform(0.01, 30), low.y + seeded.uniform(0.01, 9)});
    const Point inside{seeded.uniform(frame.low.x, frame.high.x),
                       seeded.uniform(frame.low.y, frame.high.y)};
    const double radius = std::pow(10, seeded.uniform(-2, 1.5));
    // A degree is 111.7 km at the most.
    const Point centre = random_point_at(seeded, inside, seeded.uniform(0, 1) * radius * 110'500);
    EXPECT_TRUE(may_come_near(frame, centre, radius)) << centre.x << ' ' << centre.y;
  }
}

TEST(MayComeNear, law_2_is_not_said_of_what_is_far_away) {
  const Box frame = box({10, 40}, {12, 41});
  EXPECT_FALSE(may_come_near(frame, {10, 50}, 8));
  EXPECT_FALSE(may_come_near(frame, {10, 30}, 9));
  EXPECT_FALSE(may_come_near(frame, {30, 40}, 10));
  EXPECT_FALSE(may_come_near(frame, {-170, -40}, 45));
  EXPECT_TRUE(may_come_near(frame, {30, 40}, 15));
}

TEST(EdgeDrawing, law_1_nodes_are_as_far_from_both_places_and_chords_within_the_tolerance) {
  Seeded seeded;
  for (std::uint64_t i = 0; i < Seeded::rounds(20); ++i) {
    const Point a{seeded.uniform(-170, 170), seeded.uniform(-70, 70)};
    const Point b = random_point_at(seeded, a, std::pow(10, seeded.uniform(3, 5.5)));
    const Box frame = box({a.x - 8, a.y - 8}, {a.x + 8, a.y + 8});
    const double tolerance = std::pow(10, seeded.uniform(-2, 1));
    const Diagram diagram = drawn(a, b, frame, tolerance, -0.05, 0.05);
    ASSERT_FALSE(diagram.chords.empty());
    const auto difference = [&](Point p) {
      return geodesic_distance(a, p) - geodesic_distance(b, p);
    };
    for (const Chord& chord : diagram.chords) {
      const Point from = diagram.nodes[chord.from];
      const Point to = diagram.nodes[chord.to];
      EXPECT_NEAR(difference(from), 0, 1e-4);
      EXPECT_NEAR(difference(to), 0, 1e-4);
      EXPECT_NEAR(difference({(from.x + to.x) / 2, (from.y + to.y) / 2}), 0, 2 * tolerance);
    }
  }
}

TEST(EdgeDrawing, law_2_chords_are_a_way_from_the_first_point_to_the_last_with_the_left_cell_left) {
  Seeded seeded;
  for (std::uint64_t i = 0; i < Seeded::rounds(20); ++i) {
    const Point a{seeded.uniform(-170, 170), seeded.uniform(-70, 70)};
    const Point b = random_point_at(seeded, a, 50'000);
    const Diagram diagram =
        drawn(a, b, box({a.x - 8, a.y - 8}, {a.x + 8, a.y + 8}), 0.1, -0.02, 0.02);
    ASSERT_FALSE(diagram.chords.empty());
    EXPECT_EQ(diagram.chords.front().from, 0u);
    EXPECT_EQ(diagram.chords.back().to, 1u);
    for (std::size_t c = 0; c < diagram.chords.size(); ++c) {
      const Chord& chord = diagram.chords[c];
      EXPECT_EQ(chord.left, first);
      EXPECT_EQ(chord.right, second);
      if (c > 0) {
        EXPECT_EQ(chord.from, diagram.chords[c - 1].to);
      }
    }
    // At the middle of the two places the first is on the left.
    const Point from = diagram.nodes[0];
    const Point to = diagram.nodes[1];
    const double turn = (to.x - from.x) * (a.y - from.y) - (to.y - from.y) * (a.x - from.x);
    EXPECT_GT(turn, 0);
  }
}

// Node for node, chord for chord and area for area.
TEST(EdgeDrawing, law_2b_a_short_edge_is_drawn_as_any_other) {
  Seeded seeded;
  std::size_t shorts = 0;
  std::size_t halved = 0;
  for (std::uint64_t i = 0; i < Seeded::rounds(500); ++i) {
    const Point a{seeded.uniform(-170, 170), seeded.uniform(-74, 74)};
    const Point b = random_point_at(seeded, a, std::pow(10, seeded.uniform(3, 4)));
    const Box frame = box({a.x - 8, a.y - 8}, {a.x + 8, a.y + 8});
    const double tolerance = std::pow(10, seeded.uniform(-3, 0));
    const double from = seeded.uniform(-1e-3, 0);
    const double to = from + seeded.uniform(1e-4, ShortEdge::longest);
    const Diagram expected = drawn(a, b, frame, tolerance, from, to);
    const EarthPoint left(a);
    const EarthPoint right(b);
    const auto end = [&](std::size_t node) {
      return EdgeEnd{expected.nodes[node], on_sphere(expected.nodes[node])};
    };
    const auto edge = ShortEdge::fit(left.direction, right.direction, end(0), end(1));
    Diagram found;
    found.nodes = {expected.nodes[0], expected.nodes[1]};
    EdgeDrawing drawing(frame, tolerance, 2);
    ASSERT_TRUE(drawing.may_be_short(found.nodes[0], found.nodes[1]));
    if (!edge) continue;
    ++shorts;
    if (!drawing.draw_short(*edge, {0, 0, found.nodes[0]}, {0, 1, found.nodes[1]}, first, second)) {
      ++halved;  // it crosses the equator
      continue;
    }
    drawing.add_to(found);
    ASSERT_EQ(found.nodes.size(), expected.nodes.size());
    for (std::size_t n = 2; n < found.nodes.size(); ++n)
      ASSERT_LT(geodesic_distance(found.nodes[n], expected.nodes[n]), 3e-5);
    ASSERT_EQ(found.chords.size(), expected.chords.size());
    for (std::size_t c = 0; c < found.chords.size(); ++c) {
      EXPECT_EQ(found.chords[c].from, expected.chords[c].from);
      EXPECT_EQ(found.chords[c].left, first);
      EXPECT_NEAR(found.bulges[c], expected.bulges[c], 0.1);
    }
  }
  EXPECT_GT(shorts, Seeded::rounds(450));
  EXPECT_LT(halved, Seeded::rounds(20));
}

TEST(EdgeDrawing, what_lies_at_a_side_of_the_map_or_beyond_the_frame_is_not_short) {
  const EdgeDrawing drawing(box({-180, -80}, {180, 80}), 0.1, 0);
  EXPECT_TRUE(drawing.may_be_short({10, 50}, {10.1, 50}));
  EXPECT_FALSE(drawing.may_be_short({179.5, 50}, {179.4, 50}));
  EXPECT_FALSE(drawing.may_be_short({-179.5, 50}, {179.9, 50}));
  EXPECT_FALSE(drawing.may_be_short({10, 76}, {10, 74}));
  EXPECT_FALSE(drawing.may_be_short({10, 50}, {10, -81}));
  // The map of this frame ends at 10 and at 370 degrees, and has the antimeridian in it.
  const EdgeDrawing eastern(box({170, 0}, {210, 50}), 0.1, 0);
  EXPECT_TRUE(eastern.may_be_short({175, 40}, {175.1, 40}));
  EXPECT_FALSE(eastern.may_be_short({179.9, 40}, {180.1, 40}));
}

// A chord of length s bulges by s^2.
TEST(EdgeDrawing, law_3_a_hundredth_of_the_tolerance_takes_ten_times_the_chords) {
  const Point a{10, 50};
  const Point b{10.5, 50.6};
  const Box frame = box({0, 40}, {20, 60});
  const auto coarse = drawn(a, b, frame, 1, -0.1, 0.1).chords.size();
  const auto fine = drawn(a, b, frame, 0.01, -0.1, 0.1).chords.size();
  const double ratio = static_cast<double>(fine) / static_cast<double>(coarse);
  EXPECT_GT(ratio, 7);
  EXPECT_LT(ratio, 14);
}

TEST(EdgeDrawing, law_4_what_is_far_from_the_frame_is_left_out) {
  const Point a{10, 50};
  const Point b{10.5, 50.6};
  const double pi = std::numbers::pi;
  EXPECT_TRUE(drawn(a, b, box({100, -20}, {101, -19}), 0.1, -0.3, 0.3).chords.empty());
  const Diagram diagram = drawn(a, b, box({9, 49}, {12, 52}), 0.1, -pi / 2, pi / 2);
  ASSERT_FALSE(diagram.chords.empty());
  for (const Chord& chord : diagram.chords) {
    EXPECT_NEAR(diagram.nodes[chord.from].x, 10.5, 20);
    EXPECT_NEAR(diagram.nodes[chord.from].y, 50.5, 20);
  }
}

// Between (180, 10) and (180, -10) the edge is the equator.
TEST(EdgeDrawing, law_5_a_chord_over_the_meridian_opposite_the_frame_is_drawn_once) {
  const Box world = box({-180, -90}, {180, 90});
  const Diagram diagram = drawn({180, 10}, {180, -10}, world, 100, -0.11, 0.13);
  int over = 0;
  for (std::size_t i = 0; i < diagram.chords.size(); ++i) {
    const Point from = diagram.nodes[diagram.chords[i].from];
    const Point to = diagram.nodes[diagram.chords[i].to];
    EXPECT_EQ(from.x, LongitudeTurn(world).within(from).x);
    EXPECT_NEAR(from.y, 0, 1e-9);
    if (std::abs(to.x - from.x) > 180) ++over;
    if (i > 0) {
      EXPECT_EQ(diagram.chords[i].from, diagram.chords[i - 1].to);
    }
  }
  EXPECT_EQ(over, 1);
}

TEST(EdgeDrawing, law_6_several_drawings_share_the_nodes_that_the_diagram_had_and_no_others) {
  const Box frame = box({0, 40}, {20, 60});
  const GeodesicBisector edge = edge_between({10, 50}, {10.5, 50.6});
  Diagram diagram;
  for (const double angle : {-0.02, 0.0, 0.02}) diagram.nodes.push_back(edge.find(angle).position);
  const std::vector<Point> own = diagram.nodes;
  EdgeDrawing before(frame, 0.01, 3);
  before.draw(edge, {-0.02, 0, own[0]}, {0, 1, own[1]}, first, second);
  EdgeDrawing after(frame, 0.01, 3);
  after.draw(edge, {0, 1, own[1]}, {0.02, 2, own[2]}, first, second);
  before.add_to(diagram);
  const std::size_t of_before = diagram.chords.size();
  after.add_to(diagram);
  ASSERT_GT(of_before, 1u);
  ASSERT_GT(diagram.chords.size(), of_before + 1);
  EXPECT_TRUE(std::equal(own.begin(), own.end(), diagram.nodes.begin()));
  EXPECT_EQ(diagram.chords[of_before - 1].to, 1u);
  EXPECT_EQ(diagram.chords[of_before].from, 1u);
  EXPECT_EQ(diagram.chords.back().to, 2u);
  std::vector<std::uint32_t> ends;
  for (const Chord& chord : diagram.chords) {
    ASSERT_LT(chord.to, diagram.nodes.size());
    ends.push_back(chord.to);
  }
  std::sort(ends.begin(), ends.end());
  EXPECT_EQ(std::adjacent_find(ends.begin(), ends.end()), ends.end());
}

/// The chords from a pole to what lies beyond it, as longitudes.
std::vector<double> passages(const Diagram& diagram, double pole) {
  std::vector<double> longitudes;
  for (const Chord& chord : diagram.chords) {
    const Point from = diagram.nodes[chord.from];
    const Point to = diagram.nodes[chord.to];
    if (std::max(from.y / pole, to.y / pole) <= 1) continue;
    EXPECT_EQ(std::min(from.y / pole, to.y / pole), 1);
    EXPECT_EQ(from.x, to.x);
    longitudes.push_back(from.x);
  }
  return longitudes;
}

// Two places at one latitude are parted by the meridian between them and the one opposite.
TEST(EdgeDrawing, law_7_an_edge_that_passes_a_pole_leaves_the_map_there_and_comes_back_opposite) {
  const Box world = box({-180, -90}, {180, 90});
  Seeded seeded;
  for (std::uint64_t i = 0; i < Seeded::rounds(30); ++i) {
    const double middle = static_cast<double>(seeded.whole(-35, 35)) * 5;
    const double apart = static_cast<double>(seeded.whole(1, 17)) * 5;
    const double latitude = static_cast<double>(seeded.whole(-17, 17)) * 5;
    SCOPED_TRACE(testing::Message() << middle << " " << apart << " " << latitude);
    const double pi = std::numbers::pi;
    const Diagram diagram = drawn({middle - apart, latitude}, {middle + apart, latitude}, world, 10,
                                  -0.9999 * pi, 0.9999 * pi);
    const double opposite = middle > 0 ? middle - 180 : middle + 180;
    for (const double pole : {-90.0, 90.0}) {
      const std::vector<double> longitudes = passages(diagram, pole);
      ASSERT_EQ(longitudes.size(), 2u);
      const auto [low, high] = std::minmax(longitudes[0], longitudes[1]);
      EXPECT_NEAR(low, std::min(middle, opposite == 180 ? -180 : opposite), 1e-7);
      EXPECT_NEAR(high, std::max(middle, opposite == 180 ? -180 : opposite), 1e-7);
    }
    for (const Chord& chord : diagram.chords) {
      EXPECT_NEAR(diagram.nodes[chord.from].x, diagram.nodes[chord.to].x, 1e-5);
      EXPECT_NEAR(std::remainder(diagram.nodes[chord.from].x - middle, 180), 0, 1e-5);
    }
  }
}

}  // namespace
}  // namespace thiessen
