// What a point of the sphere takes from the cells of gauges, by cutting its cell out of a plane.
#include "rainfall/methods/sphere_stolen_areas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "earth/random_points.h"
#include "oracles/half_planes.h"
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

/// What is left of a cell in the plane that touches the sphere at a point.
class TangentCell {
 public:
  explicit TangentCell(Direction middle) : middle_(middle), axes_(axes_at(middle)) {}

  /// Cuts off all that is nearer to `other` than to `own`.
  void keep_nearer(Direction own, Direction other) {
    const Direction apart = other - own;
    const long double height = dot(apart, middle_);
    const long double east = dot(apart, axes_.east);
    const long double north = dot(apart, axes_.north);
    ring_ = half_planes::kept_part(
        ring_, [&](half_planes::LongPoint p) { return height + p.x * east + p.y * north; });
  }
  /// Whether it ends within the part of the plane that is looked at.
  bool is_whole() const {
    return std::all_of(ring_.begin(), ring_.end(), [](half_planes::LongPoint p) {
      return std::max(std::abs(p.x), std::abs(p.y)) < 8;
    });
  }
  /// In triangles, whose corners are (x, y, 1) as seen from the sphere's middle.
  double area_on_sphere() const {
    long double area = 0;
    for (std::size_t i = 2; i < ring_.size(); ++i)
      area += solid_angle(ring_[0], ring_[i - 1], ring_[i]);
    return static_cast<double>(area);
  }

 private:
  static long double solid_angle(half_planes::LongPoint a, half_planes::LongPoint b,
                                 half_planes::LongPoint c) {
    const auto dot = [](half_planes::LongPoint p, half_planes::LongPoint q) {
      return p.x * q.x + p.y * q.y + 1;
    };
    const auto length = [&](half_planes::LongPoint p) { return std::sqrt(dot(p, p)); };
    return 2 * std::atan2(half_planes::doubled_area(a, b, c),
                          length(a) * length(b) * length(c) + dot(a, b) * length(c) +
                              dot(b, c) * length(a) + dot(c, a) * length(b));
  }

  Direction middle_;
  Axes axes_;
  std::vector<half_planes::LongPoint> ring_{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
};

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
