#include "diagram/plane_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/predicates.h"
#include "tessellation/families.h"
#include "tessellation/simplices.h"

namespace thiessen {
namespace {

std::vector<Point> without_repeats(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

Box box_of_points(const std::vector<Point>& points) {
  Box box;
  for (const Point p : points) box.take_in(p);
  return box;
}

double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

TEST(PlaneDiagram, of_one_place_has_no_edges) {
  const Diagram diagram = plane_diagram(std::vector<Point>{{1, 2}}, {{0, 0}, {4, 4}});
  EXPECT_TRUE(diagram.chords.empty());
  EXPECT_EQ(diagram.near({3, 3}), PlaceIndex{0});
}

TEST(PlaneDiagram, of_two_places_is_their_bisector) {
  const Diagram diagram = plane_diagram(std::vector<Point>{{0, 0}, {4, 0}}, {{0, 0}, {4, 4}});
  ASSERT_EQ(diagram.chords.size(), 1u);
  const Chord& chord = diagram.chords[0];
  const Point from = diagram.nodes[chord.from];
  const Point to = diagram.nodes[chord.to];
  EXPECT_EQ(from.x, 2);
  EXPECT_EQ(to.x, 2);
  EXPECT_LT(std::min(from.y, to.y), 0);  // beyond the frame
  EXPECT_GT(std::max(from.y, to.y), 4);
}

TEST(PlaneDiagram, of_places_on_a_line_is_parallel_edges) {
  const Diagram diagram = plane_diagram(families::line(50, {0, 0}, {1, 1}), {{0, 0}, {49, 49}});
  ASSERT_EQ(diagram.chords.size(), 49u);
  for (const Chord& chord : diagram.chords) {
    const Point from = diagram.nodes[chord.from];
    const Point to = diagram.nodes[chord.to];
    EXPECT_EQ(from.x + from.y, to.x + to.y);
    const auto lower = std::min(index(chord.left), index(chord.right));
    EXPECT_EQ(from.x + from.y, 2 * static_cast<double>(lower) + 1);
  }
}

// The corner points of 19 by 19 squares are single nodes, and no edge joins squares at a corner.
TEST(PlaneDiagram, of_a_lattice_has_no_edge_across_its_squares) {
  const Diagram diagram = plane_diagram(families::lattice(400, 1, {0, 0}, 0), {{0, 0}, {19, 19}});
  EXPECT_EQ(diagram.chords.size(), 2u * 20 * 19);
  std::set<Point> corners;
  for (const Chord& chord : diagram.chords) {
    const Point from = diagram.nodes[chord.from];
    const Point to = diagram.nodes[chord.to];
    EXPECT_TRUE(from.x == to.x || from.y == to.y);
    for (const Point p : {from, to}) {
      if (p.x > 0 && p.x < 19 && p.y > 0 && p.y < 19) corners.insert(p);
    }
  }
  EXPECT_EQ(corners.size(), 19u * 19);
  for (const Point p : corners) {
    EXPECT_EQ(p.x, std::floor(p.x) + 0.5);
    EXPECT_EQ(p.y, std::floor(p.y) + 0.5);
  }
}

TEST(PlaneDiagram, of_points_on_a_circle_has_one_node_in_the_middle) {
  for (const Point centre : {Point{0, 0}, Point{500000, 4000000}}) {
    const std::vector<Point> places = families::whole_circle(centre);
    const Diagram diagram = plane_diagram(places, box_of_points(places));
    ASSERT_EQ(diagram.chords.size(), places.size());
    std::set<std::uint32_t> ends;
    for (const Chord& chord : diagram.chords) {
      ends.insert(chord.from);
      ends.insert(chord.to);
    }
    EXPECT_EQ(ends.size(), places.size() + 1);
    EXPECT_EQ(std::count(diagram.nodes.begin(), diagram.nodes.end(), centre), 1);
  }
}

TEST(PlaneDiagram, of_every_family_has_no_edge_of_no_length) {
  Seeded seeded;
  for (const Family& family : families::all(seeded, 300)) {
    SCOPED_TRACE(family.name);
    const std::vector<Point> places = without_repeats(family.points);
    const Diagram diagram = plane_diagram(places, box_of_points(places));
    for (const Chord& chord : diagram.chords) {
      ASSERT_NE(chord.from, chord.to);
      ASSERT_NE(diagram.nodes[chord.from], diagram.nodes[chord.to]);
      ASSERT_NE(chord.left, chord.right);
    }
  }
}

// The nodes of an edge are as far from the place on its left as from that on its right.
TEST(PlaneDiagram, has_its_edges_half_way_and_their_places_on_their_sides) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(3); ++round) {
    for (const std::size_t count : {3u, 10u, 500u}) {
      const std::vector<Point> places = families::uniform(seeded, count);
      const Diagram diagram = plane_diagram(places, {{0, 0}, {1, 1}});
      for (const Chord& chord : diagram.chords) {
        const Point from = diagram.nodes[chord.from];
        const Point to = diagram.nodes[chord.to];
        const Point left = places[index(chord.left)];
        const Point right = places[index(chord.right)];
        for (const Point p : {from, to})
          ASSERT_NEAR(distance(p, left), distance(p, right), 1e-12 * distance(left, right));
        ASSERT_EQ(orientation(from, to, left), 1);
        ASSERT_EQ(orientation(from, to, right), -1);
      }
    }
  }
}

// A point that an edge does not part from its place is nearest to it: the edges miss none.
TEST(PlaneDiagram, has_every_edge_between_the_nearest_places_along_a_way) {
  Seeded seeded;
  const std::vector<Point> places = families::uniform(seeded, 100);
  const Diagram diagram = plane_diagram(places, {{0, 0}, {1, 1}});
  for (std::uint64_t round = 0; round < seeded.rounds(300); ++round) {
    const Point p{seeded.uniform(0, 1), seeded.uniform(0, 1)};
    const Point q{seeded.uniform(0, 1), seeded.uniform(0, 1)};
    const auto crosses = [&](const Chord& chord) {
      const Point from = diagram.nodes[chord.from];
      const Point to = diagram.nodes[chord.to];
      return orientation(p, q, from) != orientation(p, q, to) &&
             orientation(from, to, p) != orientation(from, to, q);
    };
    std::multiset<Point> change;
    for (const Chord& chord : diagram.chords) {
      if (!crosses(chord)) continue;
      const bool to_left = orientation(diagram.nodes[chord.from], diagram.nodes[chord.to], q) > 0;
      const Point entered = places[index(to_left ? chord.left : chord.right)];
      const Point left = places[index(to_left ? chord.right : chord.left)];
      change.insert(entered);
      change.insert({left.x + 10, left.y});
    }
    // Entered and left again but for the first and the last.
    const Point first = *nearest_one_by_one(places, p);
    const Point last = *nearest_one_by_one(places, q);
    change.insert(first);
    change.insert({last.x + 10, last.y});
    for (const Point place : places)
      ASSERT_EQ(change.count(place), change.count({place.x + 10, place.y}));
  }
}

TEST(PlaneDiagram, of_a_frame_without_area_stands) {
  const std::vector<Point> places{{0, 0}, {4, 0}, {0, 4}};
  for (const Box& frame : {Box{{2, 2}, {2, 2}}, Box{{0, 0}, {0, 4}}})
    EXPECT_FALSE(plane_diagram(places, frame).chords.empty());
  // Its surroundings are one cell's.
  const Diagram diagram = plane_diagram(places, {{0, 0}, {0, 0}});
  EXPECT_TRUE(diagram.chords.empty());
  EXPECT_EQ(diagram.near({0, 0}), PlaceIndex{0});
}

// Nearly on a line: the circle's centre lies a million kilometres off, and the edges are parallel
// but for a nanometre.
TEST(PlaneDiagram, of_a_far_centre_keeps_its_edges_apart) {
  const std::vector<Point> places{{0, 0}, {1000, 0}, {2000, 1e-9}};
  const Diagram diagram = plane_diagram(places, {{0, -1000}, {2000, 1000}});
  ASSERT_EQ(diagram.chords.size(), 2u);
  for (const Chord& chord : diagram.chords) {
    const double middle = index(chord.left) + index(chord.right) == 1 ? 500 : 1500;
    EXPECT_NEAR(diagram.nodes[chord.from].x, middle, 1e-8);
    EXPECT_NEAR(diagram.nodes[chord.to].x, middle, 1e-8);
  }
}

}  // namespace
}  // namespace thiessen
