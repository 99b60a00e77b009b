#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "geometry/point.h"

namespace thiessen::benchmarks {

class Generator {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::size_t below(std::size_t end) { return random_() % end; }

 private:
  std::mt19937_64 random_{1};
};

inline std::vector<Point> uniform(std::size_t count) {
  Generator g;
  std::vector<Point> points(count);
  for (Point& p : points) p = {g.uniform(0, 1), g.uniform(0, 1)};
  return points;
}

inline std::vector<Point> lattice(std::size_t count, double step, Point origin) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  std::vector<Point> points;
  for (std::size_t i = 0; i < side * side; ++i) {
    points.push_back({origin.x + step * static_cast<double>(i % side),
                      origin.y + step * static_cast<double>(i / side)});
  }
  return points;
}

inline std::vector<Point> whole_lattice(std::size_t count) {
  return lattice(count, 1, {0, 0});
}

inline std::vector<Point> utm_lattice(std::size_t count) {
  return lattice(count, 0.1, {500000, 4000000});
}

/// Two, a millimetre wide and 1,400 kilometres apart.
inline std::vector<Point> clusters(std::size_t count) {
  Generator g;
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double corner = 1e6 * static_cast<double>(i % 2);
    points[i] = {corner + g.uniform(0, 1e-3), corner + g.uniform(0, 1e-3)};
  }
  return points;
}

inline std::vector<Point> circle(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    points[i] = {std::cos(angle), std::sin(angle)};
  }
  return points;
}

inline std::vector<Point> parabola(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) - static_cast<double>(count) / 2;
    points[i] = {x, x * x};
  }
  return points;
}

/// Longitudes and latitudes in thousandths of a degree, many of them twice.
inline std::vector<Point> thousandths(std::size_t count) {
  Generator g;
  std::vector<Point> points(count);
  for (Point& p : points)
    p = {std::round(g.uniform(-109000, -102000)) / 1000,
         std::round(g.uniform(37000, 41000)) / 1000};
  return points;
}

/// Along a road, in whole centimetres.
inline std::vector<Point> road(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i);
    points[i] = {std::round(t * 70) / 100, std::round(t * 20 + 1000 * std::sin(t / 500)) / 100};
  }
  return points;
}

inline std::vector<SpacePoint> uniform_in_space(std::size_t count) {
  Generator g;
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) p = {g.uniform(0, 1), g.uniform(0, 1), g.uniform(0, 1)};
  return points;
}

inline std::vector<SpacePoint> cubic_lattice(std::size_t count, double step,
                                             const SpacePoint& origin) {
  const auto side = static_cast<std::size_t>(std::round(std::cbrt(static_cast<double>(count))));
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < side * side * side; ++i) {
    points.push_back({origin.x + step * static_cast<double>(i % side),
                      origin.y + step * static_cast<double>(i / side % side),
                      origin.z + step * static_cast<double>(i / side / side)});
  }
  return points;
}

inline std::vector<SpacePoint> whole_cubic_lattice(std::size_t count) {
  return cubic_lattice(count, 1, {0, 0, 0});
}

inline std::vector<SpacePoint> utm_cubic_lattice(std::size_t count) {
  return cubic_lattice(count, 0.1, {500000, 4000000, 1000});
}

inline std::vector<SpacePoint> sphere(std::size_t count) {
  Generator g;
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) {
    const double z = g.uniform(-1, 1);
    const double angle = g.uniform(0, 2 * M_PI);
    const double across = std::sqrt(1 - z * z);
    p = {across * std::cos(angle), across * std::sin(angle), z};
  }
  return points;
}

}  // namespace thiessen::benchmarks
