// Cells in a chart: edges and the areas between them and their chords, found again by bisection on
// Karney's distances.
#include "earth/cells/chart_diagram.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "earth/mesh_of_places.h"
#include "earth/sphere/conformal_sphere.h"
#include "geometry/predicates.h"
#include "geometry/segment.h"

namespace thiessen {
namespace {

constexpr double reach = 0.03;  // 190 km
constexpr ChartAccuracy few_chords{1e-5, 50};
constexpr ChartAccuracy many_chords{1e-5, 0.02};

/// The frame of the region within reach of a point at most 70 degrees from the equator.
Box frame_round(Point centre) {
  const double degrees = reach * 180 / M_PI;
  const double wide = degrees / std::cos((std::abs(centre.y) + degrees) * M_PI / 180);
  return {{centre.x - wide, centre.y - degrees}, {centre.x + wide, centre.y + degrees}};
}

class ChartDiagramOf : public testing::TestWithParam<Point> {
 protected:
  std::optional<Diagram> diagram(const ChartAccuracy& accuracy) const {
    return chart_diagram(places_, {chart_, reach, frame_round(GetParam())}, accuracy);
  }
  Point on_earth(Point p) const { return from_sphere(chart_.direction(p)); }
  Point on_chord(const Diagram& diagram, const Chord& chord, double share) const {
    return on_earth(between(diagram.nodes[chord.from], diagram.nodes[chord.to], share));
  }
  double difference(const Chord& chord, Point p) const {
    return geodesic_distance(places_[index(chord.left)], p) -
           geodesic_distance(places_[index(chord.right)], p);
  }
  /// Metres straight across the chord to the true edge, positive to the right.
  double offset(const Diagram& diagram, const Chord& chord, double share) const {
    const Point at = on_chord(diagram, chord, share);
    const Point ahead = on_chord(diagram, chord, share + 1e-3);
    double azimuth, unused;
    GeographicLib::Geodesic::WGS84().Inverse(at.y, at.x, ahead.y, ahead.x, azimuth, unused);
    const auto across = [&](double metres) {
      Point p;
      GeographicLib::Geodesic::WGS84().Direct(at.y, at.x, azimuth + 90, metres, p.y, p.x);
      return p;
    };
    double left = -1000;
    double right = 1000;
    for (int i = 0; i < 50; ++i) {
      const double middle = (left + right) / 2;
      (difference(chord, across(middle)) < 0 ? left : right) = middle;
    }
    return (left + right) / 2;
  }

  Seeded seeded_;
  std::vector<Point> places_{places_round(seeded_, GetParam(), 250'000, 20)};
  GnomonicChart chart_{on_sphere(GetParam())};
};

TEST_P(ChartDiagramOf, law_1_nodes_are_as_far_from_both_places_and_no_place_is_nearer) {
  const auto found = diagram(many_chords);
  ASSERT_TRUE(found);
  ASSERT_GT(found->chords.size(), 20u);
  for (const Chord& chord : found->chords) {
    for (const std::uint32_t node : {chord.from, chord.to}) {
      const Point p = on_earth(found->nodes[node]);
      EXPECT_NEAR(difference(chord, p), 0, 1e-3);
      EXPECT_GE(nearest_distance(places_, p),
                geodesic_distance(places_[index(chord.left)], p) - 1e-3);
      EXPECT_LE(std::hypot(found->nodes[node].x, found->nodes[node].y), std::tan(reach) + 1e-5);
    }
  }
}

TEST_P(ChartDiagramOf, law_2_edges_bend_off_their_chords_by_no_more_than_asked) {
  const auto found = diagram(many_chords);
  ASSERT_TRUE(found);
  EXPECT_GT(found->chords.size(), diagram(few_chords)->chords.size());
  for (const Chord& chord : found->chords) {
    for (const double share : {0.25, 0.5, 0.75})
      EXPECT_LE(std::abs(offset(*found, chord, share)), 1.1 * many_chords.bends);
  }
}

// By the trapezium rule, in steps so short that its own error is a thousandth.
TEST_P(ChartDiagramOf, law_3_bulges_are_the_areas_between_edges_and_chords) {
  const auto found = diagram(few_chords);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->bulges.size(), found->chords.size());
  for (std::size_t i = 0; i < found->chords.size(); ++i) {
    const Chord& chord = found->chords[i];
    constexpr int steps = 40;
    double area = 0;
    double either_way = 0;
    double before = 0;
    for (int k = 1; k <= steps; ++k) {
      const double after = k < steps ? offset(*found, chord, double(k) / steps) : 0;
      const double way = geodesic_distance(on_chord(*found, chord, double(k - 1) / steps),
                                           on_chord(*found, chord, double(k) / steps));
      area += way * (before + after) / 2;
      either_way += way * (std::abs(before) + std::abs(after)) / 2;
      before = after;
    }
    EXPECT_NEAR(found->bulges[i], area, 3e-3 * either_way + 10);
  }
}

TEST_P(ChartDiagramOf, law_4_the_left_cell_is_on_the_left) {
  const auto found = diagram(few_chords);
  ASSERT_TRUE(found);
  for (const Chord& chord : found->chords) {
    const Point from = found->nodes[chord.from];
    const Point to = found->nodes[chord.to];
    EXPECT_GT(orientation(from, to, found->places[index(chord.left)]), 0);
    EXPECT_LT(orientation(from, to, found->places[index(chord.right)]), 0);
  }
}

TEST_P(ChartDiagramOf, law_5_cells_with_a_chord_are_neighbours_and_near_is_a_place_nearly_nearest) {
  const auto found = diagram(few_chords);
  ASSERT_TRUE(found);
  std::set<std::pair<PlaceIndex, PlaceIndex>> neighbours;
  for (const auto& [a, b] : found->neighbours) neighbours.insert(std::minmax(a, b));
  for (const Chord& chord : found->chords)
    EXPECT_EQ(neighbours.count(std::minmax(chord.left, chord.right)), 1u);
  for (int i = 0; i < 100; ++i) {
    const Point p{seeded_.uniform(-reach, reach), seeded_.uniform(-reach, reach)};
    const Point near = places_[index(found->near(p))];
    EXPECT_LE(geodesic_distance(near, on_earth(p)),
              scale_variation * nearest_distance(places_, on_earth(p)));
  }
}

TEST_P(ChartDiagramOf, law_6_the_order_of_the_places_changes_no_bit) {
  const auto found = diagram(many_chords);
  std::shuffle(places_.begin(), places_.end(), seeded_.generator());
  const auto other = diagram(many_chords);
  ASSERT_TRUE(found && other);
  EXPECT_EQ(std::multiset<Point>(found->nodes.begin(), found->nodes.end()),
            std::multiset<Point>(other->nodes.begin(), other->nodes.end()));
  EXPECT_EQ(found->chords.size(), other->chords.size());
}

INSTANTIATE_TEST_SUITE_P(Everywhere, ChartDiagramOf,
                         testing::Values(Point{10, 0}, Point{10, 45}, Point{-120, -33},
                                         Point{179.9, 65}));

TEST(ChartDiagram, there_is_none_of_places_that_do_not_span_the_sphere_or_are_too_far_away) {
  const Point centre{10, 45};
  const GnomonicChart chart(on_sphere(centre));
  const ChartGround ground{chart, reach, frame_round(centre)};
  std::vector<Point> places{centre};
  EXPECT_FALSE(chart_diagram(places, ground, few_chords));
  places.push_back({11, 45});
  EXPECT_FALSE(chart_diagram(places, ground, few_chords));
  places.push_back({10.5, 46});
  EXPECT_FALSE(chart_diagram(places, ground, few_chords));
  places.push_back({9, 44});
  EXPECT_TRUE(chart_diagram(places, ground, few_chords));
  places.push_back(moved(centre, 78 * 111e3, 0));
  EXPECT_TRUE(chart_diagram(places, ground, few_chords));
  places.push_back(moved(centre, 83 * 111e3, 0));
  EXPECT_FALSE(chart_diagram(places, ground, few_chords));
}

}  // namespace
}  // namespace thiessen
