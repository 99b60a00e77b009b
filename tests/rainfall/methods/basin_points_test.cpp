#include "rainfall/methods/basin_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "basin/shapes.h"
#include "earth/area/ellipsoid_area.h"

namespace thiessen {
namespace {

const Yardstick plane{Metric::planar, 1, 0.1};
const Yardstick earth{Metric::geodesic, 1, 0.1};

/// Even-odd over all rings at once, in long double; an edge counts as inside to rounding.
bool is_inside(const Basin& basin, Point p) {
  bool inside = false;
  bool on_edge = false;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const long double ax = ring[i].x, ay = ring[i].y, bx = ring[j].x, by = ring[j].y;
      if ((ay > p.y) == (by > p.y)) continue;
      const long double x = ax + (p.y - ay) * (bx - ax) / (by - ay);
      if (std::abs(x - p.x) <= 1e-15L * (std::abs(ax) + std::abs(bx))) on_edge = true;
      if (p.x < x) inside = !inside;
    }
  };
  for (const Polygon& part : basin.shape) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return inside || on_edge;
}

/// The integral over a part of the plane of a polynomial of degree two, by its triangles with the
/// origin `o`: a third of the area for each edge's middle.
double integral(const Basin& basin, Point o, const std::function<double(Point)>& f) {
  long double sum = 0;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      const long double area = ((static_cast<long double>(a.x) - o.x) * (b.y - o.y) -
                                (static_cast<long double>(b.x) - o.x) * (a.y - o.y)) /
                               2;
      const auto middle = [](Point p, Point q) { return Point{(p.x + q.x) / 2, (p.y + q.y) / 2}; };
      sum += area * (f(middle(a, b)) + f(middle(a, o)) + f(middle(o, b))) / 3;
    }
  };
  for (const Polygon& part : basin.shape) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return static_cast<double>(sum);
}

double mean_of(const std::vector<Point>& points, const std::function<double(Point)>& f) {
  double sum = 0;
  for (const Point p : points) sum += f(p);
  return sum / static_cast<double>(points.size());
}

void expect_inside(const Basin& basin, const std::vector<Point>& points) {
  for (const Point p : points) ASSERT_TRUE(is_inside(basin, p)) << p.x << ' ' << p.y;
}

/// As many points as asked for, inside, and the mean of u, v, u^2, uv and v^2 over them that over
/// the basin, u and v running from 0 to 1 over it.
void expect_moments(const Basin& basin, std::size_t count, double accuracy) {
  const std::vector<Point> points = basin_points(basin, plane, count);
  EXPECT_EQ(points.size(), count);
  expect_inside(basin, points);
  const Box box = shapes::box_of(basin.shape);
  const auto u = [&](Point p) { return (p.x - box.low.x) / box.width(); };
  const auto v = [&](Point p) { return (p.y - box.low.y) / box.height(); };
  const double area = integral(basin, box.low, [](Point) { return 1; });
  const std::function<double(Point)> functions[] = {u, v, [&](Point p) { return u(p) * u(p); },
                                                    [&](Point p) { return u(p) * v(p); },
                                                    [&](Point p) { return v(p) * v(p); }};
  for (const auto& f : functions)
    EXPECT_NEAR(mean_of(points, f), integral(basin, box.low, f) / area, accuracy);
}

TEST(BasinPoints, a_square_has_a_lattice) {
  const std::vector<Point> points =
      basin_points(shapes::basin({{shapes::rectangle({0, 0}, {2, 2}), {}}}), plane, 4);
  EXPECT_EQ(points, (std::vector<Point>{{0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}}));
}

TEST(BasinPoints, their_means_are_those_over_the_basin) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(10); ++round) {
    const Point low{seeded.uniform(-1e6, 1e6), seeded.uniform(-1e6, 1e6)};
    const double size = std::pow(10, seeded.uniform(-2, 6));
    const Point high{low.x + size, low.y + size * seeded.uniform(0.2, 5)};
    expect_moments(shapes::basin({{shapes::rectangle(low, high), {}}}), 2000, 2e-3);
    expect_moments(shapes::basin({{shapes::star(seeded, low, size, 40), {}}}), 2000, 4e-3);
    expect_moments(shapes::basin({{shapes::snowflake(low, size, 5), {}}}), 2000, 2e-3);
    expect_moments(shapes::basin(shapes::islands(seeded, low, size, 6)), 2000, 4e-3);
    expect_moments(shapes::basin(shapes::islands(seeded, low, size, 60)), 2000, 1e-2);
    const Ring outer = shapes::star(seeded, low, size, 30);
    expect_moments(shapes::basin({{outer, {shapes::reversed(shapes::scaled(outer, low, 0.97))}}}),
                   2000, 1e-2);
  }
}

TEST(BasinPoints, they_are_the_better_the_more_they_are) {
  Seeded seeded;
  const Basin basin = shapes::basin({{shapes::star(seeded, {3, 4}, 10, 25), {}}});
  expect_moments(basin, 1, 0.5);
  expect_moments(basin, 7, 0.2);
  expect_moments(basin, 100, 0.02);
  expect_moments(basin, 10'000, 1e-3);
  expect_moments(basin, 1'000'000, 5e-5);
}

TEST(BasinPoints, slivers_have_them_all_along) {
  const auto along = [](Point a, Point b, Point width) {
    return shapes::basin(
        {{{a, {a.x + width.x, a.y + width.y}, {b.x + width.x, b.y + width.y}, b}, {}}});
  };
  expect_moments(along({0, 0}, {0, 1000}, {1e-3, 0}), 2000, 1e-2);
  expect_moments(along({0, 0}, {0, 1000}, {1e-9, 0}), 2000, 1e-2);
  expect_moments(along({0, 0}, {-1000, 0}, {0, 1e-6}), 2000, 0.03);  // two rows
  expect_moments(along({0, 0}, {-1000, 1}, {0, 0.1}), 2000, 1e-2);
  expect_moments(along({0, 0}, {-1000, 1000}, {0, 0.1}), 2000, 1e-2);
  expect_moments(along({0, 0}, {1000, 1000}, {1e-7, 0}), 2000, 1e-2);
  expect_moments(shapes::basin({{shapes::comb({0, 0}, 100, 100, 300), {}}}), 2000, 1e-2);
}

TEST(BasinPoints, islands_have_their_share_of_them) {
  // A thousand of one square metre over a thousand kilometres, and one of a thousand.
  MultiPolygon shape;
  Seeded seeded;
  for (int i = 0; i < 1000; ++i) {
    const Point low{seeded.uniform(0, 1e6), seeded.uniform(0, 1e6)};
    shape.push_back({shapes::rectangle(low, {low.x + 1, low.y + 1}), {}});
  }
  shape.push_back({shapes::rectangle({-40, 0}, {-15, 40}), {}});
  const Basin basin = shapes::basin(shape);
  const auto points = basin_points(basin, plane, 2000);
  expect_inside(basin, points);
  EXPECT_EQ(std::count_if(points.begin(), points.end(), [](Point p) { return p.x > 0; }), 1000);
}

TEST(BasinPoints, neither_starts_nor_directions_of_rings_show) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(30); ++round) {
    const Point centre{seeded.uniform(-100, 100), seeded.uniform(-50, 50)};
    Ring outer = shapes::star(seeded, centre, 20, 30);
    Ring hole = shapes::reversed(shapes::scaled(outer, centre, 0.3));
    for (const Yardstick& yardstick : {plane, earth}) {
      const auto before = basin_points(shapes::basin({{outer, {hole}}}), yardstick, 500);
      Ring turned = outer;
      std::rotate(turned.begin(), turned.begin() + seeded.whole(1, 29), turned.end());
      std::rotate(hole.begin(), hole.begin() + seeded.whole(1, 29), hole.end());
      if (round % 2 == 0) turned = shapes::reversed(turned);
      if (round % 3 == 0) hole = shapes::reversed(hole);
      EXPECT_EQ(basin_points(shapes::basin({{turned, {hole}}}), yardstick, 500), before);
    }
  }
}

/// The mean over a rectangle in longitude and latitude of a function of the latitude.
double mean_over(double south, double north, const std::function<double(double)>& f) {
  constexpr int strips = 20'000;
  double sum = 0;
  for (int i = 0; i < strips; ++i) {
    const double low = south + (north - south) * i / strips;
    const double high = south + (north - south) * (i + 1) / strips;
    sum += f((low + high) / 2) * area_under({0, high}, {1, high}, low);
  }
  return sum / area_under({0, north}, {1, north}, south);
}

// Also over the antimeridian, up to a pole, and round one.
TEST(BasinPoints, on_the_earth_each_stands_for_the_same_area) {
  struct Case {
    Point low;
    Point high;
  };
  for (const Case& box :
       {Case{{-100, 36}, {-90, 42}}, Case{{170, 51}, {230, 72}}, Case{{-180, 60}, {180, 90}},
        Case{{-180, -90}, {180, 90}}, Case{{0, -90}, {90, -89.9999}},
        Case{{179.99, -0.01}, {180.01, 0.02}}, Case{{10, 45}, {10.00001, 45.00001}}}) {
    const Point low = box.low;
    const Point high = box.high;
    const Basin basin = shapes::basin({{shapes::rectangle(low, high), {}}});
    const auto points = basin_points(basin, earth, 2000);
    EXPECT_EQ(points.size(), 2000u);
    expect_inside(basin, points);
    const auto v = [&](Point p) { return (p.y - low.y) / (high.y - low.y); };
    EXPECT_NEAR(mean_of(points, [&](Point p) { return (p.x - low.x) / (high.x - low.x); }), 0.5,
                1e-3);
    EXPECT_NEAR(mean_of(points, v),
                mean_over(low.y, high.y,
                          [&](double y) {
                            return v({0, y});
                          }),
                1e-3);
    EXPECT_NEAR(mean_of(points, [&](Point p) { return v(p) * v(p); }),
                mean_over(low.y, high.y,
                          [&](double y) {
                            return v({0, y}) * v({0, y});
                          }),
                1e-3);
  }
}

TEST(BasinPoints, a_basin_thinner_than_doubles_has_them) {
  const double y = std::nextafter(1e6, 2e6);
  const Basin basin = shapes::basin({{shapes::rectangle({1e6, 1e6}, {2e6, y}), {}}});
  const auto points = basin_points(basin, plane, 100);
  EXPECT_EQ(points.size(), 100u);
  for (const Point p : points) EXPECT_TRUE(shapes::box_of(basin.shape).contains(p));
}

}  // namespace
}  // namespace thiessen
