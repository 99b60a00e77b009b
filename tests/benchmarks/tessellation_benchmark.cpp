// Building the tessellation, beside CGAL's of the same points: seconds, and nanoseconds a point.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "tessellation/plane_diagram.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

class Generator {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::mt19937_64 random_{1};
};

std::vector<Point> uniform(std::size_t count) {
  Generator g;
  std::vector<Point> points(count);
  for (Point& p : points) p = {g.uniform(0, 1), g.uniform(0, 1)};
  return points;
}

std::vector<Point> lattice(std::size_t count, double step, Point origin) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  std::vector<Point> points;
  for (std::size_t i = 0; i < side * side; ++i) {
    points.push_back({origin.x + step * static_cast<double>(i % side),
                      origin.y + step * static_cast<double>(i / side)});
  }
  return points;
}

std::vector<Point> whole_lattice(std::size_t count) {
  return lattice(count, 1, {0, 0});
}

std::vector<Point> utm_lattice(std::size_t count) {
  return lattice(count, 0.1, {500000, 4000000});
}

std::vector<Point> clusters(std::size_t count) {
  Generator g;
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double corner = 1e6 * static_cast<double>(i % 2);
    points[i] = {corner + g.uniform(0, 1e-3), corner + g.uniform(0, 1e-3)};
  }
  return points;
}

std::vector<Point> circle(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    points[i] = {std::cos(angle), std::sin(angle)};
  }
  return points;
}

std::vector<Point> parabola(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) - static_cast<double>(count) / 2;
    points[i] = {x, x * x};
  }
  return points;
}

// Longitudes and latitudes in thousandths of a degree, many of them twice.
std::vector<Point> thousandths(std::size_t count) {
  Generator g;
  std::vector<Point> points(count);
  for (Point& p : points)
    p = {std::round(g.uniform(-109000, -102000)) / 1000,
         std::round(g.uniform(37000, 41000)) / 1000};
  return points;
}

// Along a road, in whole centimetres.
std::vector<Point> road(std::size_t count) {
  std::vector<Point> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i);
    points[i] = {std::round(t * 70) / 100, std::round(t * 20 + 1000 * std::sin(t / 500)) / 100};
  }
  return points;
}

using Family = std::vector<Point> (*)(std::size_t);

void count_points(benchmark::State& state, std::size_t count) {
  state.counters["a point"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

void build_ours(benchmark::State& state, Family family) {
  const std::vector<Point> points = family(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    Tessellation tessellation;
    tessellation.add_all(points);
    benchmark::DoNotOptimize(tessellation.topology().size());
  }
  count_points(state, points.size());
}

void build_cgal(benchmark::State& state, Family family) {
  std::vector<Kernel::Point_2> points;
  for (const Point p : family(static_cast<std::size_t>(state.range(0))))
    points.emplace_back(p.x, p.y);
  for (auto _ : state) {
    const Triangulation triangulation(points.begin(), points.end());
    benchmark::DoNotOptimize(triangulation.number_of_faces());
  }
  count_points(state, points.size());
}

void build_diagram(benchmark::State& state, Family family) {
  const std::vector<Point> points = family(static_cast<std::size_t>(state.range(0)));
  Box frame;
  for (const Point p : points) frame.take_in(p);
  for (auto _ : state) benchmark::DoNotOptimize(plane_diagram(points, frame).chords.size());
  count_points(state, points.size());
}

void nearest(benchmark::State& state) {
  const std::vector<Point> points = uniform(static_cast<std::size_t>(state.range(0)));
  Tessellation tessellation;
  tessellation.add_all(points);
  Generator g;
  for (auto _ : state)
    benchmark::DoNotOptimize(tessellation.nearest({g.uniform(0, 1), g.uniform(0, 1)}));
}

#define THIESSEN_FAMILY(family)                 \
  BENCHMARK_CAPTURE(build_ours, family, family) \
      ->Arg(10000)                              \
      ->Arg(100000)                             \
      ->Arg(1000000)                            \
      ->Unit(benchmark::kMillisecond);          \
  BENCHMARK_CAPTURE(build_cgal, family, family) \
      ->Arg(10000)                              \
      ->Arg(100000)                             \
      ->Arg(1000000)                            \
      ->Unit(benchmark::kMillisecond)

THIESSEN_FAMILY(uniform);
THIESSEN_FAMILY(whole_lattice);
THIESSEN_FAMILY(utm_lattice);
THIESSEN_FAMILY(clusters);
THIESSEN_FAMILY(circle);
THIESSEN_FAMILY(parabola);
THIESSEN_FAMILY(thousandths);
THIESSEN_FAMILY(road);
BENCHMARK_CAPTURE(build_diagram, uniform, uniform)
    ->Arg(10000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_diagram, utm_lattice, utm_lattice)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(nearest)->Arg(10000)->Arg(1000000);

}  // namespace
}  // namespace thiessen
