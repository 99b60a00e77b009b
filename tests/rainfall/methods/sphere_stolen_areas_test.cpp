// What a point of the sphere takes from the cells of gauges, by cutting its cell out of a plane.
#include "rainfall/methods/sphere_stolen_areas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/tangent_cell.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

TEST(SphericalArea, of_an_octant_and_of_small_ones) {
  EXPECT_NEAR(spherical_area({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), M_PI / 2, 1e-15);
  EXPECT_NEAR(spherical_area({0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -M_PI / 2, 1e-15);
  // Two right-angled triangles of sides a and b: tan(E / 2) = tan(a / 2) tan(b / 2).
  for (const double a : {1.0, 0.1, 1e-3, 1e-6}) {
    const double area = spherical_area({1, 0, 0}, {std::cos(a), std::sin(a), 0},
                                       {std::cos(a / 2), 0, std::sin(a / 2)});
    EXPECT_NEAR(area / (2 * std::atan(std::tan(a / 2) * std::tan(a / 4))), 1, 1e-9);
  }
}

TEST(SphereStolenAreas, are_what_the_points_cell_has_of_the_gauges_cells) {
  Seeded seeded;
  std::size_t found = 0;
  for (std::uint64_t round = 0; round < Seeded::rounds(30); ++round) {
    const Point centre = random_point(seeded);
    const double size = std::pow(10, seeded.uniform(4, 6.3));  // metres
    const StereographicChart chart(-1 * on_sphere(centre));
    std::vector<Point> charted;
    std::vector<Direction> gauges;
    for (int i = 0; i < 40; ++i) {
      gauges.push_back(on_sphere(random_point_at(seeded, centre, size * seeded.uniform(0, 1))));
      charted.push_back(chart.project(gauges.back()));
    }
    Tessellation<2> tessellation;
    const std::vector<PointId> numbers = tessellation.add_all(charted);
    std::vector<Direction> by_number(tessellation.topology().point_limit());
    for (std::size_t i = 0; i < gauges.size(); ++i) by_number[index(numbers[i])] = gauges[i];
    SphereStolenAreas stolen;
    stolen.take(tessellation.topology(), by_number);
    for (int i = 0; i < 20; ++i) {
      const Direction x = on_sphere(random_point_at(seeded, centre, 0.6 * size));
      ConflictZone<2> zone;
      ASSERT_TRUE(tessellation.find_conflict_zone(chart.project(x), {}, zone));
      bool is_inside = true;
      for (const VertexId v : zone.vertices())
        is_inside = is_inside && !tessellation.topology().is_infinite(v);
      TangentCell cell(x);
      for (const Direction g : gauges) cell.keep_nearer(x, g);
      if (!is_inside || !cell.is_whole()) continue;
      ++found;
      std::vector<StolenArea> areas;
      stolen.find(tessellation.topology(), zone, by_number, x, areas);
      ASSERT_EQ(areas.size(), zone.rim().size());
      const double whole = cell.area_on_sphere();
      for (const StolenArea& area : areas) {
        TangentCell part = cell;
        for (const Direction g : gauges) part.keep_nearer(by_number[index(area.gauge)], g);
        EXPECT_NEAR(area.area, part.area_on_sphere(), 1e-8 * whole + 1e-17);
      }
    }
  }
  EXPECT_GT(found, Seeded::rounds(300));
}

}  // namespace
}  // namespace thiessen
