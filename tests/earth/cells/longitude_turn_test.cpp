// The map's turn of longitudes, and what is drawn at its seam.
#include "earth/cells/longitude_turn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

Box box(Point low, Point high) {
  return {low, high};
}

TEST(LongitudeTurn, law_1_is_half_a_turn_to_each_side_of_the_frame_and_changes_no_place) {
  Seeded seeded;
  for (int i = 0; i < 100; ++i) {
    const double middle = seeded.uniform(-180, 180);
    const LongitudeTurn turn(box({middle - 1, 0}, {middle + 1, 1}));
    const Point p{seeded.uniform(-360, 360), 5};
    const Point q = turn.within(p);
    EXPECT_GE(q.x, turn.west());
    EXPECT_LT(q.x, turn.west() + 360);
    EXPECT_NEAR(std::remainder(q.x - p.x, 360), 0, 1e-11);
    EXPECT_EQ(q.y, p.y);
  }
}

// At latitude 60 a micrometre is 1.8e-11 degrees of longitude, at 89.99999 it is 5.15e-5.
TEST(LongitudeTurn, law_2_what_is_within_a_micrometre_of_the_seam_or_the_antimeridian_is_on_it) {
  const LongitudeTurn world(box({-180, -90}, {180, 90}));
  const LongitudeTurn pacific(box({160, -20}, {190, 20}));
  for (const double turn : {-360, 0, 360}) {
    for (const double off : {0.0, 2.9e-14, -2.9e-14, 1.6e-11, -1.6e-11}) {
      EXPECT_EQ(world.within({180 + turn + off, 60}).x, -180);
      EXPECT_EQ(pacific.within({180 + turn + off, 60}).x, 180);
      EXPECT_EQ(pacific.within({355 + turn + off, 60}).x, -5);
    }
    EXPECT_GT(world.within({180 + turn + 3e-11, 60}).x, -180);
    EXPECT_LT(world.within({180 + turn - 3e-11, 60}).x, 180);
    EXPECT_GT(world.within({180 + turn - 3e-11, 60}).x, 179);
    EXPECT_EQ(world.within({180 + turn - 4e-5, -89.99999}).x, -180);
    EXPECT_GT(world.within({180 + turn - 6e-5, -89.99999}).x, 179);
  }
}

TEST(LongitudeTurn, law_3_keeps_the_bits_of_a_longitude_that_is_within) {
  Seeded seeded;
  const LongitudeTurn world(box({-180, -90}, {180, 90}));
  for (int i = 0; i < 100; ++i) {
    const Point p{seeded.uniform(-179, 179), seeded.uniform(-90, 90)};
    EXPECT_EQ(world.within(p), p);
    const Point pole{p.x, 90};
    EXPECT_EQ(world.within(pole), pole);
  }
}

/// A corner on the seam, from which one border leads along it and one to each side, and a border
/// that crosses it elsewhere.
Diagram at_the_seam() {
  Diagram diagram;
  diagram.nodes = {{-180, 10}, {-180, 20}, {-170, 0}, {170, 0}, {175, 40}, {-175, 42}, {0, 0}};
  const PlaceIndex a{0};
  const PlaceIndex b{1};
  const PlaceIndex c{2};
  diagram.chords = {{0, 1, a, b}, {0, 2, b, c}, {3, 0, a, c}, {4, 5, a, b}, {2, 6, b, c}};
  diagram.bulges = {1, 2, 3, 4, 5};
  return diagram;
}

TEST(LongitudeTurn, law_4_draws_a_turn_further_what_is_on_the_seam_and_all_else_once) {
  Diagram diagram = at_the_seam();
  LongitudeTurn(box({-180, -90}, {180, 90})).draw_on_both_sides(diagram);
  std::set<std::pair<std::pair<Point, Point>, double>> drawn;
  ASSERT_EQ(diagram.bulges.size(), diagram.chords.size());
  for (std::size_t i = 0; i < diagram.chords.size(); ++i)
    drawn.insert({{diagram.nodes[diagram.chords[i].from], diagram.nodes[diagram.chords[i].to]},
                  diagram.bulges[i]});
  const std::set<std::pair<std::pair<Point, Point>, double>> expected = {
      {{{-180, 10}, {-180, 20}}, 1}, {{{180, 10}, {180, 20}}, 1},   {{{-180, 10}, {-170, 0}}, 2},
      {{{180, 10}, {190, 0}}, 2},    {{{170, 0}, {180, 10}}, 3},    {{{-190, 0}, {-180, 10}}, 3},
      {{{175, 40}, {185, 42}}, 4},   {{{-185, 40}, {-175, 42}}, 4}, {{{-170, 0}, {0, 0}}, 5}};
  EXPECT_EQ(drawn, expected);
  EXPECT_EQ(diagram.chords.size(), expected.size());
}

TEST(LongitudeTurn, law_5_chords_that_meet_have_one_node_on_either_side) {
  Diagram diagram = at_the_seam();
  LongitudeTurn(box({-180, -90}, {180, 90})).draw_on_both_sides(diagram);
  std::map<Point, std::set<std::uint32_t>> nodes;
  for (const Chord& chord : diagram.chords) {
    for (const std::uint32_t node : {chord.from, chord.to}) nodes[diagram.nodes[node]].insert(node);
  }
  for (const auto& [point, numbers] : nodes)
    EXPECT_EQ(numbers.size(), 1u) << point.x << " " << point.y;
}

TEST(LongitudeTurn, law_6_leaves_a_diagram_away_from_the_seam_as_it_is) {
  Diagram diagram;
  diagram.nodes = {{-179, 10}, {0, 20}, {180, 0}};
  diagram.chords = {{0, 1, PlaceIndex{0}, PlaceIndex{1}}, {1, 2, PlaceIndex{0}, PlaceIndex{1}}};
  LongitudeTurn(box({0, -90}, {10, 90})).draw_on_both_sides(diagram);
  EXPECT_EQ(diagram.nodes.size(), 3u);
  EXPECT_EQ(diagram.chords.size(), 2u);
}

}  // namespace
}  // namespace thiessen
