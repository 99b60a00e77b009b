#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "geometry/point.h"
#include "geometry/seeded.h"
#include "tessellation/families.h"

namespace thiessen::families {

inline std::vector<SpacePoint> uniform_in_space(Seeded& seeded, std::size_t count) {
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points)
    p = {seeded.uniform(0, 1), seeded.uniform(0, 1), seeded.uniform(0, 1)};
  return points;
}

inline std::vector<SpacePoint> clustered_in_space(Seeded& seeded, std::size_t count,
                                                  std::size_t clusters, double width) {
  const std::vector<SpacePoint> centres = uniform_in_space(seeded, clusters);
  std::vector<SpacePoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const SpacePoint& c = centres[i % clusters];
    points[i] = {c.x + seeded.uniform(0, width), c.y + seeded.uniform(0, width),
                 c.z + seeded.uniform(0, width)};
  }
  return points;
}

/// A cubic lattice with such a step, from `origin`, turned by `angle` radians round two axes.
inline std::vector<SpacePoint> lattice_in_space(std::size_t count, double step,
                                                const SpacePoint& origin, double angle) {
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  const double c = angle == 0 ? 1 : std::cos(angle);
  const double s = angle == 0 ? 0 : std::sin(angle);
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < side * side * side; ++i) {
    const double u = step * static_cast<double>(i % side);
    const double v = step * static_cast<double>(i / side % side);
    const double w = step * static_cast<double>(i / side / side);
    const double turned = angle == 0 ? v : u * s + v * c;
    points.push_back({origin.x + (angle == 0 ? u : u * c - v * s),
                      origin.y + (angle == 0 ? v : turned * c - w * s),
                      origin.z + (angle == 0 ? w : turned * s + w * c)});
  }
  return points;
}

/// The points of a sphere whose square is `square` that have whole coordinates: exactly
/// cospherical.
inline std::vector<SpacePoint> whole_sphere(int square, const SpacePoint& centre) {
  std::vector<SpacePoint> points;
  const int radius = static_cast<int>(std::sqrt(square));
  for (int x = -radius; x <= radius; ++x) {
    for (int y = -radius; y <= radius; ++y) {
      for (int z = -radius; z <= radius; ++z) {
        if (x * x + y * y + z * z == square)
          points.push_back({centre.x + x, centre.y + y, centre.z + z});
      }
    }
  }
  return points;
}

inline std::vector<SpacePoint> rounded_sphere(Seeded& seeded, std::size_t count,
                                              const SpacePoint& centre, double radius) {
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) {
    const double z = seeded.uniform(-1, 1);
    const double angle = seeded.uniform(0, 2 * M_PI);
    const double across = radius * std::sqrt(1 - z * z);
    p = {centre.x + across * std::cos(angle), centre.y + across * std::sin(angle),
         centre.z + radius * z};
  }
  return points;
}

/// The plane's points in space, in a plane of whole coefficients exactly if they are whole.
inline std::vector<SpacePoint> on_plane(const std::vector<Point>& points, const SpacePoint& origin,
                                        double slope_x, double slope_y) {
  std::vector<SpacePoint> on;
  for (const Point& p : points)
    on.push_back({origin.x + p.x, origin.y + p.y, origin.z + slope_x * p.x + slope_y * p.y});
  return on;
}

inline std::vector<SpacePoint> line_in_space(std::size_t count, const SpacePoint& origin,
                                             const SpacePoint& step) {
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto k = static_cast<double>(i);
    points.push_back({origin.x + k * step.x, origin.y + k * step.y, origin.z + k * step.z});
  }
  return points;
}

inline std::vector<SpacePoint> moment_curve(std::size_t count) {
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) - static_cast<double>(count / 2);
    points.push_back({t, t * t, t * t * t});
  }
  return points;
}

inline std::vector<SpacePoint> ulp_cluster_in_space(Seeded& seeded, std::size_t count,
                                                    const SpacePoint& centre, int ulps) {
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points)
    p = {seeded.near(centre.x, ulps), seeded.near(centre.y, ulps), seeded.near(centre.z, ulps)};
  return points;
}

inline std::vector<SpacePoint> mixed_scales_in_space(Seeded& seeded, std::size_t count) {
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) {
    const double scale = std::pow(10, seeded.uniform(-8, 8));
    p = {scale * seeded.uniform(-1, 1), scale * seeded.uniform(-1, 1),
         scale * seeded.uniform(-1, 1)};
  }
  return points;
}

inline std::vector<SpacePoint> small_grid_in_space(Seeded& seeded, std::size_t count,
                                                   std::int64_t side) {
  const auto whole = [&] {
    const auto c = static_cast<double>(seeded.whole(-side, side));
    return c == 0 && seeded.below(2) == 0 ? -0.0 : c;
  };
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) p = {whole(), whole(), whole()};
  return points;
}

/// Pairs of equal x and y, one over the other.
inline std::vector<SpacePoint> columns(Seeded& seeded, std::size_t count) {
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < count / 2 + 1; ++i) {
    const double x = seeded.uniform(0, 1);
    const double y = seeded.uniform(0, 1);
    points.push_back({x, y, 0});
    points.push_back({x, y, seeded.uniform(0, 1)});
  }
  return points;
}

/// Within 1e-13 of a plane, so that simplices are slivers.
inline std::vector<SpacePoint> slivers(Seeded& seeded, std::size_t count) {
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) {
    p.x = seeded.uniform(0, 1);
    p.y = seeded.uniform(0, 1);
    p.z = 0.1 * p.x + 0.7 * p.y + seeded.uniform(0, 1e-13);
  }
  return points;
}

inline std::vector<SpacePoint> icosahedron() {
  const double golden = (1 + std::sqrt(5)) / 2;
  std::vector<SpacePoint> points;
  for (const double one : {-1.0, 1.0}) {
    for (const double other : {-golden, golden}) {
      points.push_back({0, one, other});
      points.push_back({one, other, 0});
      points.push_back({other, 0, one});
    }
  }
  return points;
}

/// On two lines past each other: every edge of the one meets every edge of the other in a simplex.
inline std::vector<SpacePoint> skew_lines(std::size_t count) {
  std::vector<SpacePoint> points = line_in_space(count / 2 + 1, {0, 0, 0}, {1, 0, 0});
  for (const SpacePoint& p : line_in_space(count / 2 + 1, {3, -2, 5}, {0, 1, 0}))
    points.push_back(p);
  return points;
}

inline std::vector<SpacePoint> with(std::vector<SpacePoint> points,
                                    const std::vector<SpacePoint>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

/// Every family in space, of about `count` points; those with a quadratic number of simplices of
/// at most 150.
inline std::vector<FamilyIn<3>> all_in_space(Seeded& seeded, std::size_t count) {
  const SpacePoint utm{500000, 4000000, 1000};
  const std::size_t few = std::min<std::size_t>(count, 150);
  const std::vector<Point> grid = lattice(count, 1, {0, 0}, 0);
  std::vector<FamilyIn<3>> all{
      {"uniform", uniform_in_space(seeded, count)},
      {"clusters", clustered_in_space(seeded, count, 5, 1e-6)},
      {"two far clusters", with(clustered_in_space(seeded, count / 2, 1, 1e-3),
                                lattice_in_space(count / 2, 1e-4, {1e6, 1e6, 1e6}, 0.3))},
      {"lattice", lattice_in_space(count, 1, {0, 0, 0}, 0)},
      {"lattice in tenths", lattice_in_space(count, 0.1, {0, 0, 0}, 0)},
      {"lattice in tenths at UTM offsets", lattice_in_space(count, 0.1, utm, 0)},
      {"rotated lattice", lattice_in_space(count, 1, {0, 0, 0}, 0.3)},
      {"whole sphere", whole_sphere(29, {0, 0, 0})},
      {"whole sphere and centre", with(whole_sphere(29, utm), {utm})},
      {"rounded sphere", rounded_sphere(seeded, count, {0, 0, 0}, 1)},
      {"rounded sphere at UTM offsets", rounded_sphere(seeded, count, utm, 1000)},
      {"cube", lattice_in_space(8, 1, {0, 0, 0}, 0)},
      {"cube and centre", with(lattice_in_space(8, 2, {0, 0, 0}, 0), {{1, 1, 1}})},
      {"icosahedron", icosahedron()},
      {"plane", on_plane(grid, {1, 2, 3}, 2, -1)},
      {"upright plane", on_plane(grid, {0, 0, 0}, 0, 0)},
      {"plane plus one", with(on_plane(grid, {0, 0, 0}, 2, -1), {{1, 1, 9}})},
      {"plane plus one on either side",
       with(on_plane(grid, {0, 0, 0}, 0, 1), {{1, 1, 9}, {2, 2, -30}})},
      {"circle in a plane", on_plane(whole_circle({0, 0}), {0, 0, 0}, 0, 0)},
      {"circle in a plane plus one", with(on_plane(whole_circle({0, 0}), {}, 0, 0), {{0, 0, 7}})},
      {"line", line_in_space(count, {0, 0, 0}, {1, 2, -3})},
      {"line plus one", with(line_in_space(few, {0, 0, 0}, {0, 0, 1}), {{5, 3, 1}})},
      {"line plus two", with(line_in_space(few, {0, 0, 0}, {1, 2, -3}), {{5, 3, 1}, {-9, 400, 2}})},
      {"line in tenths", line_in_space(few, {0, 0, 0}, {0.1, 0.3, 0.7})},
      {"skew lines", skew_lines(few)},
      {"ulp cluster", ulp_cluster_in_space(seeded, count, {0.5, 0.5, 0.5}, 3)},
      {"ulp cluster and far corners", with(ulp_cluster_in_space(seeded, count, {1e5, 3e5, 2e5}, 8),
                                           lattice_in_space(8, 1e6, {0, 0, 0}, 0))},
      {"mixed scales", mixed_scales_in_space(seeded, count)},
      {"moment curve", moment_curve(few)},
      {"small grid with duplicates", small_grid_in_space(seeded, count, 2)},
      {"columns", columns(seeded, count)},
      {"slivers", slivers(seeded, count)},
      {"road", on_plane(road(few), {0, 0, 0}, 0.01, 0.02)},
      {"needle", clustered_in_space(seeded, count, 1, 1e6)},
      {"lattice times 1e-8", lattice_in_space(count, 1e-8, {1e-8, 0, 0}, 0.1)},
      {"lattice times 1e8", lattice_in_space(count, 1e8, {1e8, 0, 0}, 0.1)},
  };
  for (FamilyIn<3>& family : all) {
    if (family.name != "needle") continue;
    for (SpacePoint& p : family.points) p = {p.x, p.y * 1e-12, p.z * 1e-12};
  }
  return all;
}

/// Every family of a dimension.
template <int Dimension>
std::vector<FamilyIn<Dimension>> all_in(Seeded& seeded, std::size_t count) {
  if constexpr (Dimension == 2) {
    std::vector<Family> families = all(seeded, count);
    families.push_back({"road", road(count)});
    families.push_back({"flat arc", flat_arc(count)});
    families.push_back({"snowflake", koch(count)});
    return families;
  } else {
    return all_in_space(seeded, count);
  }
}

}  // namespace thiessen::families
