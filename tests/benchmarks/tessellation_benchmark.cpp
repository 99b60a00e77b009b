// Building the plane's tessellation, beside CGAL's of the same points: time and memory a point.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

#include "benchmarks/memory_in_use.h"
#include "benchmarks/point_sets.h"
#include "diagram/plane_diagram.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

using namespace benchmarks;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

using Family = std::vector<Point> (*)(std::size_t);

void build_ours(benchmark::State& state, Family family) {
  const std::vector<Point> points = family(static_cast<std::size_t>(state.range(0)));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::size_t before = memory_in_use();
    Tessellation<2> tessellation;
    tessellation.add_all(points);
    benchmark::DoNotOptimize(tessellation.topology().size());
    bytes = memory_in_use() - before;
  }
  count_points(state, points.size(), bytes);
}

void build_cgal(benchmark::State& state, Family family) {
  std::vector<Kernel::Point_2> points;
  for (const Point p : family(static_cast<std::size_t>(state.range(0))))
    points.emplace_back(p.x, p.y);
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::size_t before = memory_in_use();
    const Triangulation triangulation(points.begin(), points.end());
    benchmark::DoNotOptimize(triangulation.number_of_faces());
    bytes = memory_in_use() - before;
  }
  count_points(state, points.size(), bytes);
}

void build_diagram(benchmark::State& state, Family family) {
  const std::vector<Point> points = family(static_cast<std::size_t>(state.range(0)));
  Box frame;
  for (const Point p : points) frame.take_in(p);
  for (auto _ : state) benchmark::DoNotOptimize(plane_diagram(points, frame).chords.size());
  count_points(state, points.size(), 0);
}

void nearest(benchmark::State& state) {
  const std::vector<Point> points = uniform(static_cast<std::size_t>(state.range(0)));
  Tessellation<2> tessellation;
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
BENCHMARK_CAPTURE(build_ours, uniform, uniform)->Arg(10000000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(build_cgal, uniform, uniform)->Arg(10000000)->Unit(benchmark::kMillisecond);
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
