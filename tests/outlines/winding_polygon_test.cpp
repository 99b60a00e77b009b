#include "outlines/winding_polygon.h"

#include <gtest/gtest.h>
#include <algorithm>

#include "base/complaints.h"
#include "outlines/ellipsoid_strip.h"
#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

/// Round the Earth on a parallel, from a longitude, in so many steps.
Ring parallel(double latitude, double from = -180, int steps = 12) {
  Ring ring;
  for (int i = 0; i < steps; ++i) {
    const double longitude = from + 360.0 * i / steps;
    ring.push_back({longitude > 180 ? longitude - 360 : longitude, latitude});
  }
  return ring;
}

CurvedShape shape_of(const std::vector<Ring>& rings) {
  std::vector<WindingRing> winding;
  for (const Ring& ring : rings) winding.push_back(ring_the_short_way(ring));
  CurvedShape shape;
  EXPECT_EQ(add_polygon(std::move(winding), Longitudes::cut, shape), "");
  EXPECT_EQ(validity_fault(shape.shape), "");
  for (const Polygon& polygon : shape.shape) {
    for (const Point point : polygon.outer) EXPECT_LE(std::abs(point.x), 180);
  }
  return shape;
}

std::string fault_of(const Ring& ring) {
  CurvedShape shape;
  return add_polygon({ring_the_short_way(ring)}, Longitudes::run_on, shape);
}

void expect_area(const CurvedShape& shape, double area) {
  EXPECT_NEAR(area_on_earth(shape) / area, 1, 1e-11);
}

TEST(WindingPolygon, holds_the_nearer_pole_whichever_way_it_runs) {
  for (const double latitude : {60.0, -60.0, 3.0, -89.5}) {
    for (const double from : {-180.0, 17.3}) {
      Ring ring = parallel(latitude, from);
      const double area = strip_area(std::abs(latitude), 90, 360);
      expect_area(shape_of({ring}), area);
      std::reverse(ring.begin(), ring.end());
      expect_area(shape_of({ring}), area);
    }
  }
}

TEST(WindingPolygon, runs_up_the_antimeridian_and_along_the_pole) {
  const CurvedShape shape = shape_of({{{-90, 70}, {0, 60}, {90, 70}, {180, 80}}});
  ASSERT_EQ(shape.shape.size(), 1U);
  const Ring expected = {{-180, 80}, {-90, 70}, {0, 60},   {90, 70},
                         {180, 80},  {180, 90}, {-180, 90}};
  EXPECT_EQ(shape.shape[0].outer, expected);
}

TEST(WindingPolygon, crosses_the_antimeridian_back_and_forth) {
  // Three crossings, at 61, 66 and 71: a bay from the east and a cape from the west.
  const CurvedShape shape = shape_of(
      {{{170, 60}, {-170, 62}, {-170, 65}, {170, 67}, {170, 70}, {-170, 72}, {-60, 60}, {60, 60}}});
  ASSERT_EQ(shape.shape.size(), 2U);
  double area = 0;
  // The same ring in one plane, from 170 once round, closed over the pole there.
  const Ring plane = {{170, 60}, {190, 62}, {190, 65}, {170, 67}, {170, 70}, {190, 72},
                      {300, 60}, {420, 60}, {530, 60}, {530, 90}, {170, 90}};
  for (std::size_t i = 0; i < plane.size(); ++i)
    area -= area_under(plane[i], plane[(i + 1) % plane.size()], 0);
  expect_area(shape, area);
}

TEST(WindingPolygon, with_a_hole_that_winds_is_a_band) {
  expect_area(shape_of({parallel(60), parallel(80, 45)}), strip_area(60, 80, 360));
  expect_area(shape_of({parallel(-70), parallel(-75)}), strip_area(-75, -70, 360));
  expect_area(shape_of({parallel(23.5), parallel(-23.5)}), strip_area(-23.5, 23.5, 360));
  expect_area(shape_of({parallel(0), parallel(-10)}), strip_area(-10, 0, 360));
}

TEST(WindingPolygon, with_holes_at_the_pole) {
  const Ring cap = {{-180, 60}, {-60, 60}, {60, 60}, {180, 60}, {180, 90}, {-180, 90}};
  const Ring pole = {{-180, 80}, {-60, 80}, {60, 80}, {180, 80}, {180, 90}, {-180, 90}};
  const Ring wedge = {{-30, 70}, {30, 70}, {30, 90}, {-30, 90}};
  expect_area(shape_of({cap, parallel(80, 10)}), strip_area(60, 80, 360));
  expect_area(shape_of({cap, pole}), strip_area(60, 80, 360));
  expect_area(shape_of({parallel(60), pole}), strip_area(60, 80, 360));
  expect_area(shape_of({parallel(60), wedge}), strip_area(60, 90, 360) - strip_area(70, 90, 60));
  Ring south = cap;
  for (Point& point : south) point.y = -point.y;
  expect_area(shape_of({south, parallel(-80, 10)}), strip_area(60, 80, 360));
}

TEST(WindingPolygon, with_points_along_the_pole_needs_no_nearer_one) {
  const double cap = strip_area(60, 90, 360);
  const Ring base = {{-180, 60}, {-60, 60}, {60, 60}, {180, 60}};
  for (const Ring& top : {Ring{{180, 90}, {-180, 90}}, Ring{{180, 90}, {-100, 90}, {-180, 90}},
                          Ring{{180, 90}, {-10, 90}, {-180, 90}},
                          Ring{{180, 90}, {60, 90}, {-60, 90}, {-180, 90}}, Ring{{180, 90}}}) {
    Ring ring = base;
    ring.insert(ring.end(), top.begin(), top.end());
    expect_area(shape_of({ring}), cap);
  }
  expect_area(shape_of({{{-180, 60}, {-60, 60}, {60, 60}, {90, 60}, {90, 90}, {-180, 90}}}),
              cap * 270 / 360);
  expect_area(shape_of({{{170, 60}, {-170, 60}, {-170, 90}, {170, 90}}}), cap * 20 / 360);
  // A file's own seam, at Greenwich.
  expect_area(shape_of({{{0, 60}, {120, 60}, {240, 60}, {360, 60}, {360, 90}, {0, 90}}}), cap);
}

TEST(WindingPolygon, that_touches_the_pole_has_straight_edges_there) {
  const CurvedShape shape = shape_of({{{0, 60}, {90, 60}, {180, 60}, {-90, 60}, {0, 90}}});
  const Ring plane = {{0, 60}, {90, 60}, {180, 60}, {270, 60}, {360, 90}, {0, 90}};
  double area = 0;
  for (std::size_t i = 0; i < plane.size(); ++i)
    area -= area_under(plane[i], plane[(i + 1) % plane.size()], 0);
  expect_area(shape, area);
}

TEST(WindingPolygon, wider_than_a_turn_is_cut) {
  const Ring spiral = {{0, 10},  {100, 15}, {-160, 20}, {-60, 25}, {40, 30},
                       {40, 40}, {-60, 35}, {-160, 30}, {100, 25}, {0, 20}};
  const CurvedShape shape = shape_of({spiral});
  EXPECT_EQ(shape.shape.size(), 2U);
  double area = 0;
  const Ring plane = {{0, 10},   {100, 15}, {200, 20}, {300, 25}, {400, 30},
                      {400, 40}, {300, 35}, {200, 30}, {100, 25}, {0, 20}};
  for (std::size_t i = 0; i < plane.size(); ++i)
    area -= area_under(plane[i], plane[(i + 1) % plane.size()], 0);
  expect_area(shape, area);
}

TEST(WindingPolygon, cannot_wind_twice_or_along_the_equator) {
  Ring twice = parallel(60);
  const Ring again = parallel(70);
  twice.insert(twice.end(), again.begin(), again.end());
  EXPECT_TRUE(contains(fault_of(twice), "begins at -180 60 winds round the Earth 2 times"));
  EXPECT_TRUE(contains(fault_of(parallel(0)), "along the equator: neither pole is nearer"));
  EXPECT_EQ(fault_of(parallel(0.001)), "");
}

TEST(WindingPolygon, beside_the_antimeridian_runs_on_or_is_cut) {
  const Ring outer = {{170, 0}, {-170, 0}, {-170, 10}, {170, 10}};
  const Ring hole = {{-175, 2}, {-172, 4}, {-172, 2}};
  CurvedShape on;
  EXPECT_EQ(
      add_polygon({ring_the_short_way(outer), ring_the_short_way(hole)}, Longitudes::run_on, on),
      "");
  EXPECT_EQ(on.shape.at(0).outer, (Ring{{170, 0}, {190, 0}, {190, 10}, {170, 10}}));
  EXPECT_EQ(on.shape.at(0).holes.at(0), (Ring{{185, 2}, {188, 4}, {188, 2}}));
  const CurvedShape cut = shape_of({outer, hole});
  ASSERT_EQ(cut.shape.size(), 2U);
  EXPECT_EQ(cut.shape[0].holes.size() + cut.shape[1].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(area_on_earth(cut), area_on_earth(on));
}

}  // namespace
}  // namespace thiessen
