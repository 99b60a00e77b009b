// What a point of the plane takes from the cells of gauges, by half-planes.
#include "rainfall/methods/plane_stolen_areas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "oracles/half_planes.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

struct Gauges {
  explicit Gauges(std::vector<Point> its_places)
      : places(std::move(its_places)), numbers(tessellation.add_all(places)) {}

  /// The area taken from each gauge, by place; empty where the point is on the hull or beyond it.
  std::vector<double> stolen_by(Point x, PlaneStolenAreas& areas) const {
    ConflictZone<2> zone;
    if (!tessellation.find_conflict_zone(x, {}, zone)) return {};
    for (const VertexId v : zone.vertices()) {
      if (tessellation.topology().is_infinite(v)) return {};
    }
    std::vector<StolenArea> stolen;
    areas.find(tessellation.structure(), zone, x, stolen);
    EXPECT_EQ(stolen.size(), zone.rim().size());
    std::vector<double> by_place(places.size(), 0);
    for (std::size_t i = 0; i < stolen.size(); ++i) {
      EXPECT_EQ(stolen[i].gauge, begin_of(tessellation.topology(), zone.rim()[i]));
      EXPECT_GE(stolen[i].area, 0);
      for (std::size_t p = 0; p < places.size(); ++p) {
        if (numbers[p] == stolen[i].gauge) by_place[p] += stolen[i].area;
      }
    }
    return by_place;
  }

  std::vector<Point> places;
  Tessellation<2> tessellation;
  std::vector<PointId> numbers;
};

/// Scattered in a unit square, and every other time on a lattice, so that circles hold more than
/// three.
std::vector<Point> random_places(Seeded& seeded, bool on_lattice) {
  std::vector<Point> places;
  for (int i = 0; i < 50; ++i) {
    places.push_back({seeded.uniform(0, 1), seeded.uniform(0, 1)});
    if (on_lattice) {
      for (double* c : {&places.back().x, &places.back().y}) *c = std::round(8 * *c) / 8;
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

// The cell of the point among the gauges, and what it has in common with each gauge's cell.
TEST(PlaneStolenAreas, law_1_are_what_the_points_cell_has_of_the_gauges_cells) {
  Seeded seeded;
  PlaneStolenAreas areas;
  std::size_t found = 0;
  for (std::uint64_t round = 0; round < Seeded::rounds(10); ++round) {
    const Gauges gauges(random_places(seeded, round % 2 == 0));
    for (int i = 0; i < 20; ++i) {
      Point x{seeded.uniform(0.2, 0.8), seeded.uniform(0.2, 0.8)};
      if (i % 2 == 0) x = {std::round(16 * x.x) / 16, std::round(16 * x.y) / 16};
      const std::vector<double> stolen = gauges.stolen_by(x, areas);
      std::vector<Point> all = gauges.places;
      all.push_back(x);
      const Box box{{-2, -2}, {3, 3}};
      const Ring cell = half_planes::cell(all, all.size() - 1, box);
      const bool leaves_box = std::any_of(cell.begin(), cell.end(), [](Point p) {
        return std::max(std::abs(p.x - 0.5), std::abs(p.y - 0.5)) > 2.4;
      });
      if (stolen.empty() || leaves_box) continue;
      ++found;
      const double total = std::accumulate(stolen.begin(), stolen.end(), 0.0);
      for (std::size_t p = 0; p < stolen.size(); ++p) {
        const double expected = half_planes::common_area(gauges.places, p, box, {{cell, {}}});
        ASSERT_NEAR(stolen[p], expected, 2e-13 * total + 1e-14) << x.x << ' ' << x.y;
      }
    }
  }
  EXPECT_GT(found, Seeded::rounds(125));
}

// As a unit square's corners take it: from each a triangle of sides 1 / 2.
TEST(PlaneStolenAreas, law_2_in_the_middle_of_a_square_are_an_eighth_from_each_corner) {
  const Gauges square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  PlaneStolenAreas areas;
  for (const double area : square.stolen_by({0.5, 0.5}, areas)) EXPECT_DOUBLE_EQ(area, 0.125);
}

// So near to a gauge that doubles do not tell the two apart by their distances' squares: half of
// its cell goes. The gauges round it lose next to nothing.
TEST(PlaneStolenAreas, law_3_next_to_a_gauge_are_half_of_its_cell) {
  const Gauges cross({{5, 5}, {4, 5}, {6, 5}, {5, 4}, {5, 6}});
  PlaneStolenAreas areas;
  const auto stolen = cross.stolen_by({std::nextafter(5.0, 6.0), 5}, areas);
  ASSERT_EQ(stolen.size(), 5u);
  EXPECT_NEAR(stolen[0], 0.5, 1e-13);
  for (std::size_t p = 1; p < 5; ++p) EXPECT_NEAR(stolen[p], 0, 1e-13);
}

}  // namespace
}  // namespace thiessen
