#include "earth/yardstick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagram/plane_diagram.h"
#include "earth/random_points.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

constexpr Box frame{{8, 46}, {12, 49}};

std::vector<Point> places() {
  Seeded seeded;
  std::vector<Point> places;
  for (int i = 0; i < 30; ++i) places.push_back({seeded.uniform(8, 12), seeded.uniform(46, 49)});
  return places;
}

TEST(Yardstick, law_1_a_plane_s_diagrams_are_those_of_the_plane) {
  const Yardstick plane{Metric::planar, 1, 20};
  const Diagram expected = plane_diagram(places(), frame);
  for (const Diagram& found :
       {plane.diagram(places(), frame, 2), plane.drawn_diagram(places(), frame, 2),
        plane.diagram_of_heirs(places(), frame)}) {
    EXPECT_EQ(found.nodes, expected.nodes);
    EXPECT_EQ(found.chords.size(), expected.chords.size());
    EXPECT_EQ(found.period, 0);
  }
  EXPECT_TRUE(plane.draws_as_measured());
}

// How much nearer to one place than to the other the middle of a chord is at most.
double greatest_difference(const Diagram& diagram, const std::vector<Point>& all) {
  double greatest = 0;
  for (const Chord& chord : diagram.chords) {
    const Point from = diagram.nodes[chord.from];
    const Point to = diagram.nodes[chord.to];
    const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
    if (!frame.contains(middle)) continue;
    const double left = geodesic_distance(all[index(chord.left)], middle);
    const double right = geodesic_distance(all[index(chord.right)], middle);
    greatest = std::max(greatest, std::abs(left - right));
  }
  return greatest;
}

// A point that is off the edge by a length is nearer to one place than to the other by twice that
// at most. A tenth of a metre is what areas need whatever is drawn.
TEST(Yardstick, law_2_the_earth_s_chords_lie_within_half_the_tolerance_of_equal_distance) {
  constexpr double vertices = 2e-6;  // metres
  const auto all = places();
  for (const double tolerance : {0.1, 20.0}) {
    const Yardstick earth{Metric::geodesic, 1, tolerance};
    const Diagram measured = earth.diagram(all, frame, 1);
    const Diagram drawn = earth.drawn_diagram(all, frame, 1);
    const Diagram of_heirs = earth.diagram_of_heirs(all, frame);
    for (const Diagram* diagram : {&measured, &drawn, &of_heirs}) {
      EXPECT_EQ(diagram->period, 360);
      EXPECT_GT(diagram->chords.size(), 50u);
    }
    EXPECT_LE(greatest_difference(measured, all), 0.1 + vertices);
    EXPECT_LE(greatest_difference(drawn, all), tolerance + vertices);
    EXPECT_LE(greatest_difference(of_heirs, all), 0.1 + 2 * Yardstick::accuracy_of_heirs);
  }
}

TEST(Yardstick, law_3_a_smaller_tolerance_takes_more_chords_to_draw_and_the_same_to_measure) {
  const Yardstick coarse{Metric::geodesic, 1, 20};
  const Yardstick fine{Metric::geodesic, 1, 0.01};
  EXPECT_GT(fine.drawn_diagram(places(), frame, 1).chords.size(),
            coarse.drawn_diagram(places(), frame, 1).chords.size());
  EXPECT_EQ(fine.diagram(places(), frame, 1).nodes, coarse.diagram(places(), frame, 1).nodes);
}

TEST(Yardstick, law_4_at_the_usual_tolerance_cells_are_drawn_as_they_are_measured) {
  const Yardstick usual{Metric::geodesic, 1, 0.1};
  EXPECT_TRUE(usual.draws_as_measured());
  EXPECT_FALSE((Yardstick{Metric::geodesic, 1, 0.05}.draws_as_measured()));
  EXPECT_EQ(usual.drawn_diagram(places(), frame, 1).nodes, usual.diagram(places(), frame, 1).nodes);
}

// Half the Earth is as large as half the sphere of WGS 84's authalic radius.
TEST(Yardstick, law_5_areas_are_of_the_plane_s_unit_or_of_the_ellipsoid) {
  const auto area = [](const Yardstick& yardstick, Point high) {
    const auto surface = yardstick.surface();
    return surface->under({0, high.y}, high, 0);
  };
  EXPECT_EQ(area({Metric::planar, 1, 0.1}, {2, 3}), 6);
  EXPECT_EQ(area({Metric::planar, 0.25, 0.1}, {2, 3}), 1.5);
  const double authalic_radius = 6371007.181;
  const double whole = area({Metric::geodesic, 1, 0.1}, {360, 90});
  EXPECT_NEAR(whole, 2 * M_PI * authalic_radius * authalic_radius, 1e-9 * whole);
}

}  // namespace
}  // namespace thiessen
