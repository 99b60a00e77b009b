#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "geometry/point.h"
#include "geometry/seeded.h"

namespace thiessen {

/// A kind of point set that breaks tessellations.
template <int Dimension>
struct FamilyIn {
  std::string name;
  std::vector<PositionIn<Dimension>> points;
};
using Family = FamilyIn<2>;

namespace families {

inline std::vector<Point> uniform(Seeded& seeded, std::size_t count) {
  std::vector<Point> points(count);
  for (Point& p : points) p = {seeded.uniform(0, 1), seeded.uniform(0, 1)};
  return points;
}

/// Clusters `width` wide in the unit square.
inline std::vector<Point> clustered(Seeded& seeded, std::size_t count, std::size_t clusters,
                                    double width) {
  const std::vector<Point> centres = uniform(seeded, clusters);
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point c = centres[i % clusters];
    points[i] = {c.x + seeded.uniform(0, width), c.y + seeded.uniform(0, width)};
  }
  return points;
}

/// A square lattice with such a step, from `origin`, turned by `angle` radians.
inline std::vector<Point> lattice(std::size_t count, double step, Point origin, double angle) {
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  std::vector<Point> points;
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      const double u = step * static_cast<double>(column);
      const double v = step * static_cast<double>(row);
      if (angle == 0) {
        points.push_back({origin.x + u, origin.y + v});
      } else {
        points.push_back({origin.x + u * std::cos(angle) - v * std::sin(angle),
                          origin.y + u * std::sin(angle) + v * std::cos(angle)});
      }
    }
  }
  return points;
}

/// The points of a circle of radius 325 whose coordinates are whole: all exactly cocircular.
inline std::vector<Point> whole_circle(Point centre) {
  std::vector<Point> points;
  for (int x = -325; x <= 325; ++x) {
    const int y = static_cast<int>(std::lround(std::sqrt(325 * 325 - x * x)));
    if (x * x + y * y != 325 * 325) continue;
    points.push_back({centre.x + x, centre.y - y});
    if (y != 0) points.push_back({centre.x + x, centre.y + y});
  }
  return points;
}

inline std::vector<Point> rounded_circle(std::size_t count, Point centre, double radius) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

/// On one line exactly, unless `step` is no power of two.
inline std::vector<Point> line(std::size_t count, Point origin, Point step) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<double>(i);
    points.push_back({origin.x + k * step.x, origin.y + k * step.y});
  }
  return points;
}

inline std::vector<Point> ulp_cluster(Seeded& seeded, std::size_t count, Point centre, int ulps) {
  std::vector<Point> points(count);
  for (Point& p : points) p = {seeded.near(centre.x, ulps), seeded.near(centre.y, ulps)};
  return points;
}

inline std::vector<Point> mixed_scales(Seeded& seeded, std::size_t count) {
  std::vector<Point> points(count);
  for (Point& p : points) {
    const double scale = std::pow(10, seeded.uniform(-8, 8));
    p = {scale * seeded.uniform(-1, 1), scale * seeded.uniform(-1, 1)};
  }
  return points;
}

inline std::vector<Point> parabola(std::size_t count) {
  std::vector<Point> points;
  const auto half = static_cast<double>(count) / 2;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) - std::floor(half);
    points.push_back({x, x * x});
  }
  return points;
}

inline std::vector<Point> spiral(std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    points.push_back({t * std::cos(t), t * std::sin(t)});
  }
  return points;
}

/// Along a road, in whole centimetres.
inline std::vector<Point> road(std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<double>(i);
    points.push_back(
        {std::round(t * 70) / 100, std::round(t * 20 + 1000 * std::sin(t / 500)) / 100});
  }
  return points;
}

/// Bulging 1e-12 over a length of 1 at most.
inline std::vector<Point> flat_arc(std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(count);
    points.push_back({x, 4e-12 * x * (1 - x)});
  }
  return points;
}

/// Koch's snowflake, its corners after as many steps as it takes.
inline std::vector<Point> koch(std::size_t count) {
  std::vector<Point> ring{{0, 0}, {0.5, std::sqrt(0.75)}, {1, 0}};
  while (4 * ring.size() <= std::max<std::size_t>(count, 12)) {
    std::vector<Point> finer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      const Point third{(b.x - a.x) / 3, (b.y - a.y) / 3};
      const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
      const double height = std::sqrt(0.75);
      finer.push_back(a);
      finer.push_back({a.x + third.x, a.y + third.y});
      finer.push_back({middle.x - height * third.y, middle.y + height * third.x});
      finer.push_back({b.x - third.x, b.y - third.y});
    }
    ring = std::move(finer);
  }
  return ring;
}

inline std::vector<Point> with(std::vector<Point> points, const std::vector<Point>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

inline std::vector<Point> small_grid(Seeded& seeded, std::size_t count, std::int64_t side) {
  std::vector<Point> points(count);
  for (Point& p : points) {
    p = {static_cast<double>(seeded.whole(-side, side)),
         static_cast<double>(seeded.whole(-side, side))};
    if (p.x == 0 && seeded.below(2) == 0) p.x = -0.0;
  }
  return points;
}

/// Every family, of about `count` points.
inline std::vector<Family> all(Seeded& seeded, std::size_t count) {
  const Point utm{500000, 4000000};
  std::vector<Family> all{
      {"uniform", uniform(seeded, count)},
      {"clusters", clustered(seeded, count, 5, 1e-6)},
      {"two far clusters",
       with(clustered(seeded, count / 2, 1, 1e-3), lattice(count / 2, 1e-4, {1e6, 1e6}, 0.3))},
      {"lattice", lattice(count, 1, {0, 0}, 0)},
      {"lattice in tenths", lattice(count, 0.1, {0, 0}, 0)},
      {"lattice in tenths at UTM offsets", lattice(count, 0.1, utm, 0)},
      {"rotated lattice", lattice(count, 1, {0, 0}, 0.3)},
      {"lattice at 302.328 degrees", lattice(count, 1, {0, 0}, 302.328 * M_PI / 180)},
      {"whole circle", whole_circle({0, 0})},
      {"whole circle and centre", with(whole_circle(utm), {utm})},
      {"rounded circle", rounded_circle(count, {0, 0}, 1)},
      {"rounded circle at UTM offsets", rounded_circle(17, utm, 1000)},
      {"line", line(count, {0, 0}, {1, 2})},
      {"vertical line", line(count, {3, -7}, {0, 1})},
      {"line plus one", with(line(count, {0, 0}, {1, 2}), {{5, 3}})},
      {"line plus one on either side", with(line(count, {0, 0}, {1, 2}), {{5, 3}, {-9, 400}})},
      {"line in tenths", line(count, {0, 0}, {0.1, 0.3})},
      {"ulp cluster", ulp_cluster(seeded, count, {0.5, 0.5}, 4)},
      {"ulp cluster and far corners",
       with(ulp_cluster(seeded, count, {1e5, 3e5}, 8), {{0, 0}, {1e6, 0}, {0, 1e6}, {1e6, 1e6}})},
      {"mixed scales", mixed_scales(seeded, count)},
      {"parabola", parabola(count)},
      {"spiral", spiral(count)},
      {"small grid with duplicates", small_grid(seeded, count, 3)},
      {"needle", clustered(seeded, count, 1, 1e6)},
  };
  for (Point& p : all.back().points) p.y *= 1e-12;
  for (const double scale : {1e-8, 1e8}) {
    Family scaled{"lattice times " + std::to_string(scale), lattice(count, scale, {scale, 0}, 0.1)};
    all.push_back(std::move(scaled));
  }
  return all;
}

}  // namespace families
}  // namespace thiessen
