#include "earth/cells/geodesic_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "earth/area/ellipsoid_area.h"
#include "earth/sphere/geodesic.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double tolerance = 0.05;

struct Network {
  const char* name;
  Point centre;
  double width;
  double height;
  int places;
};

std::vector<Point> places_of(const Network& network, Seeded& seeded) {
  std::vector<Point> places(static_cast<std::size_t>(network.places));
  for (Point& place : places) {
    place = {network.centre.x + network.width * seeded.uniform(-0.5, 0.5),
             network.centre.y + network.height * seeded.uniform(-0.5, 0.5)};
  }
  return places;
}

Box frame_of(const Network& network) {
  Box frame;
  frame.take_in(
      Point{network.centre.x - 0.6 * network.width, network.centre.y - 0.6 * network.height});
  frame.take_in(
      Point{network.centre.x + 0.6 * network.width, network.centre.y + 0.6 * network.height});
  return frame;
}

double distance_to_nearest(const std::vector<Point>& places, Point p) {
  double least = HUGE_VAL;
  for (const Point place : places) least = std::min(least, geodesic_distance(place, p));
  return least;
}

/// No place is nearer to a point of a chord than those on its two sides, which are equally near.
void expect_between(const std::vector<Point>& places, const Chord& chord, Point p, double allowed) {
  const double left = geodesic_distance(places[index(chord.left)], p);
  const double right = geodesic_distance(places[index(chord.right)], p);
  EXPECT_NEAR(left, right, 2 * allowed) << p.x << ' ' << p.y;
  EXPECT_GE(distance_to_nearest(places, p), std::min(left, right) - 2 * allowed)
      << p.x << ' ' << p.y;
}

class GeodesicDiagram : public testing::TestWithParam<Network> {};

TEST_P(GeodesicDiagram, has_edges_at_equal_distance_of_their_places_and_farther_from_others) {
  Seeded seeded;
  const Network network = GetParam();
  const std::vector<Point> places = places_of(network, seeded);
  const Box frame = frame_of(network);
  const Diagram diagram = geodesic_diagram(places, frame, tolerance, 1e-6, 2);
  ASSERT_FALSE(diagram.chords.empty());
  for (std::size_t i = 0; i < diagram.chords.size(); i += 1 + diagram.chords.size() / 1500) {
    const Chord& chord = diagram.chords[i];
    const Point from = diagram.nodes[chord.from];
    const Point to = diagram.nodes[chord.to];
    const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
    if (!frame.contains(middle)) continue;
    if (frame.contains(from)) expect_between(places, chord, from, 1e-4);
    expect_between(places, chord, middle, tolerance);
  }
}

/// An edge between two cells as its chords tell it.
struct EdgeSum {
  std::map<std::uint32_t, int> nodes;  // by node: how many more chords begin than end there
  double area = 0;                     // between the true edge and a parallel
  double length = 0;

  /// The nodes at which the edge begins and ends; false where it is not one line.
  bool ends(const Diagram& diagram, Point& from, Point& to) const {
    int count = 0;
    for (const auto& [node, balance] : nodes) {
      if (balance == 0) continue;
      ++count;
      (balance > 0 ? from : to) = diagram.nodes[node];
    }
    return count == 2;
  }
};

std::map<std::pair<PlaceIndex, PlaceIndex>, EdgeSum> edge_sums(const Diagram& diagram) {
  std::map<std::pair<PlaceIndex, PlaceIndex>, EdgeSum> sums;
  for (std::size_t i = 0; i < diagram.chords.size(); ++i) {
    const Chord& chord = diagram.chords[i];
    const Point from = diagram.nodes[chord.from];
    const Point to = diagram.nodes[chord.to];
    EdgeSum& sum = sums[{chord.left, chord.right}];
    ++sum.nodes[chord.from];
    --sum.nodes[chord.to];
    sum.area += area_under(from, to, diagram.frame.centre().y) - diagram.bulges[i];
    sum.length += geodesic_distance(from, to);
  }
  return sums;
}

// Law: chords with their bulges enclose the true edge's area, however few there are. The ends of
// chords are right to 1e-5 metres.
TEST_P(GeodesicDiagram, law_the_area_beside_an_edge_does_not_depend_on_its_chords) {
  Seeded seeded;
  const Network network = GetParam();
  const std::vector<Point> places = places_of(network, seeded);
  const Diagram fine = geodesic_diagram(places, frame_of(network), 0.005, 1e-6, 2);
  const Diagram usual = geodesic_diagram(places, frame_of(network), 0.05, 1e-6, 2);
  const auto of_fine = edge_sums(fine);
  std::size_t compared = 0;
  for (const auto& [cells, edge] : edge_sums(usual)) {
    Point from, to, fine_from, fine_to;
    const auto other = of_fine.find(cells);
    if (other == of_fine.end() || !edge.ends(usual, from, to)) continue;
    if (!other->second.ends(fine, fine_from, fine_to) || from != fine_from || to != fine_to)
      continue;
    ++compared;
    EXPECT_NEAR(edge.area, other->second.area, 2e-5 * edge.length + 1e-4) << edge.length;
  }
  EXPECT_GT(compared, places.size());
}

INSTANTIATE_TEST_SUITE_P(Everywhere, GeodesicDiagram,
                         testing::Values(Network{"equator", {10, 0}, 0.2, 0.2, 50},
                                         Network{"town_45", {10, 45}, 0.3, 0.2, 50},
                                         Network{"north_68", {20, 68}, 12, 5, 200},
                                         Network{"north_85", {100, 85}, 60, 4, 100},
                                         Network{"south_85", {100, -85}, 60, 4, 100},
                                         Network{"fiji", {179, -17}, 6, 6, 100},
                                         Network{"continent", {-100, 40}, 50, 40, 200}),
                         [](const auto& test) { return test.param.name; });

// The corners of a grid's cells are at one distance of four places by symmetry.
TEST(GeodesicDiagramOfAGrid, has_one_node_for_four_cells) {
  std::vector<Point> places;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j) places.push_back({10 + 0.5 * i, 50 + 0.25 * j});
  }
  Box frame;
  frame.take_in(Point{9.9, 49.9});
  frame.take_in(Point{12.6, 51.1});
  const Diagram diagram = geodesic_diagram(places, frame, tolerance, 1e-6, 1);
  for (const Chord& chord : diagram.chords) {
    const Point from = diagram.nodes[chord.from];
    const Point to = diagram.nodes[chord.to];
    EXPECT_GT(geodesic_distance(from, to), 1);
  }
}

TEST(GeodesicDiagramOfTwoPlaces, is_one_closed_line) {
  const std::vector<Point> places{{0, 10}, {40, -20}};
  Box frame;
  frame.take_in(Point{-180, -90});
  frame.take_in(Point{180, 90});
  const Diagram diagram = geodesic_diagram(places, frame, 1000, 1e-6, 1);
  ASSERT_FALSE(diagram.chords.empty());
  for (const Chord& chord : diagram.chords) {
    expect_between(places, chord, diagram.nodes[chord.from], 1e-4);
  }
}

// They are looked at in another order within; what comes out has the caller's numbers.
TEST(GeodesicDiagramOfManyPlaces, law_knows_each_place_by_its_number) {
  Seeded seeded;
  const Network network{"many", {-105, 40}, 1, 1, 1500};
  std::vector<Point> places = places_of(network, seeded);
  places.push_back({places[7].x, places[7].y + 1e-13});  // shares its cell
  const Diagram diagram = geodesic_diagram(places, frame_of(network), tolerance, 1e-6, 1);
  EXPECT_EQ(diagram.places, places);
  ASSERT_EQ(diagram.cell_of.size(), places.size());
  for (std::uint32_t p = 0; p + 1 < places.size(); ++p) {
    if (p != 7) {
      EXPECT_EQ(diagram.cell_of[p], PlaceIndex{p});
    }
    EXPECT_EQ(diagram.near(places[p]), diagram.cell_of[p]);
  }
  EXPECT_EQ(diagram.cell_of[7], diagram.cell_of.back());
  for (std::size_t c = 0; c < diagram.chords.size(); c += 50) {
    const Chord& chord = diagram.chords[c];
    expect_between(places, chord, diagram.nodes[chord.from], 1e-5);
    expect_between(places, chord, diagram.nodes[chord.to], 1e-5);
  }
}

TEST(GeodesicDiagramOnThreads, is_the_same) {
  Seeded seeded;
  const Network network{"", {20, 60}, 10, 5, 3000};
  const std::vector<Point> places = places_of(network, seeded);
  const Diagram one = geodesic_diagram(places, frame_of(network), tolerance, 1e-6, 1);
  const Diagram three = geodesic_diagram(places, frame_of(network), tolerance, 1e-6, 3);
  EXPECT_EQ(one.nodes, three.nodes);
  ASSERT_EQ(one.chords.size(), three.chords.size());
  for (std::size_t i = 0; i < one.chords.size(); ++i) {
    EXPECT_EQ(one.chords[i].from, three.chords[i].from);
    EXPECT_EQ(one.chords[i].to, three.chords[i].to);
  }
}

}  // namespace
}  // namespace thiessen
