// The tessellation of space, beside CGAL's of the same points: building, deleting, adding again.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "benchmarks/memory_in_use.h"
#include "benchmarks/point_sets.h"
#include "benchmarks/timer.h"
#include "tessellation/history.h"

namespace thiessen {
namespace {

using namespace benchmarks;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Family = std::vector<SpacePoint> (*)(std::size_t);

std::vector<Kernel::Point_3> theirs(const std::vector<SpacePoint>& points) {
  std::vector<Kernel::Point_3> copies;
  for (const SpacePoint& p : points) copies.emplace_back(p.x, p.y, p.z);
  return copies;
}

void build_space_ours(benchmark::State& state, Family family) {
  const std::vector<SpacePoint> points = family(static_cast<std::size_t>(state.range(0)));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::size_t before = memory_in_use();
    Tessellation<3> tessellation;
    tessellation.add_all(points);
    benchmark::DoNotOptimize(tessellation.topology().size());
    bytes = memory_in_use() - before;
  }
  count_points(state, points.size(), bytes);
}

void build_space_cgal(benchmark::State& state, Family family) {
  const auto points = theirs(family(static_cast<std::size_t>(state.range(0))));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::size_t before = memory_in_use();
    const Triangulation triangulation(points.begin(), points.end());
    benchmark::DoNotOptimize(triangulation.number_of_cells());
    bytes = memory_in_use() - before;
  }
  count_points(state, points.size(), bytes);
}

/// One point in `stride`, the first of them inside: every time the same.
constexpr std::size_t stride = 50;

enum class Step { deletion, insertion, undo };

/// For each point that is deleted a neighbour that is not.
std::vector<std::size_t> hints_of(const std::vector<SpacePoint>& points) {
  Tessellation<3> tessellation;
  const std::vector<PointId> numbers = tessellation.add_all(points);
  std::vector<std::size_t> place(tessellation.topology().point_limit());
  for (std::size_t k = 0; k < points.size(); ++k) place[index(numbers[k])] = k;
  std::vector<std::size_t> hints(points.size());
  for (std::size_t k = stride; k < points.size(); k += stride) {
    tessellation.for_each_neighbour(numbers[k], [&](PointId p) {
      if (place[index(p)] % stride != 0) hints[k] = place[index(p)];
    });
  }
  return hints;
}

// Points are deleted one after another, and then added again where they were, with a hint.
void change_space_ours(benchmark::State& state, Family family, Step step) {
  const std::vector<SpacePoint> points = family(static_cast<std::size_t>(state.range(0)));
  const std::vector<std::size_t> hints = hints_of(points);
  for (auto _ : state) {
    History<3> history;
    std::vector<PointId> numbers = history.add_all(points);
    Timer timer;
    std::size_t operations = 0;
    const auto time = [&](bool is_timed, auto&& work) {
      if (is_timed) timer.start();
      for (std::size_t k = stride; k < points.size(); k += stride) work(k);
      if (is_timed) timer.stop();
    };
    for (std::size_t k = stride; k < points.size(); k += stride) ++operations;
    time(step == Step::deletion, [&](std::size_t k) { history.remove(numbers[k]); });
    if (step == Step::insertion)
      time(true, [&](std::size_t k) { history.add(points[k], numbers[hints[k]]); });
    if (step == Step::undo) time(true, [&](std::size_t) { history.undo(); });
    count_operations(state, operations, timer);
  }
}

// Insertion without a record by which it could be undone; CGAL keeps none either.
void insert_space_ours(benchmark::State& state, Family family) {
  const std::vector<SpacePoint> points = family(static_cast<std::size_t>(state.range(0)));
  const std::vector<std::size_t> hints = hints_of(points);
  for (auto _ : state) {
    Tessellation<3> tessellation;
    const std::vector<PointId> numbers = tessellation.add_all(points);
    std::size_t operations = 0;
    for (std::size_t k = stride; k < points.size(); k += stride, ++operations)
      tessellation.remove(numbers[k]);
    Timer timer;
    timer.start();
    for (std::size_t k = stride; k < points.size(); k += stride)
      tessellation.add(points[k], numbers[hints[k]]);
    timer.stop();
    count_operations(state, operations, timer);
  }
}

void change_space_cgal(benchmark::State& state, Family family, Step step) {
  const std::vector<SpacePoint> ours = family(static_cast<std::size_t>(state.range(0)));
  const auto points = theirs(ours);
  const std::vector<std::size_t> hints = hints_of(ours);
  for (auto _ : state) {
    Triangulation triangulation(points.begin(), points.end());
    std::vector<Triangulation::Vertex_handle> vertices;
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
         ++v)
      vertices.push_back(v);
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
    std::sort(vertices.begin(), vertices.end(),
              [](auto a, auto b) { return a->point() < b->point(); });
    std::vector<Triangulation::Vertex_handle> at(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) at[order[i]] = vertices[i];
    Timer timer;
    std::size_t operations = 0;
    for (std::size_t k = stride; k < points.size(); k += stride) ++operations;
    if (step == Step::deletion) timer.start();
    for (std::size_t k = stride; k < points.size(); k += stride) triangulation.remove(at[k]);
    if (step == Step::deletion) timer.stop();
    if (step == Step::insertion) {
      timer.start();
      for (std::size_t k = stride; k < points.size(); k += stride)
        triangulation.insert(points[k], at[hints[k]]);
      timer.stop();
    }
    count_operations(state, operations, timer);
  }
}

#define THIESSEN_SPACE(family)                                                                     \
  BENCHMARK_CAPTURE(build_space_ours, family, family)->Arg(100000)->Unit(benchmark::kMillisecond); \
  BENCHMARK_CAPTURE(build_space_cgal, family, family)->Arg(100000)->Unit(benchmark::kMillisecond)

THIESSEN_SPACE(uniform_in_space);
THIESSEN_SPACE(whole_cubic_lattice);
THIESSEN_SPACE(utm_cubic_lattice);
THIESSEN_SPACE(sphere);

#define THIESSEN_SPACE_CHANGE(side, step)                                                 \
  BENCHMARK_CAPTURE(change_space_##side, step, uniform_in_space, Step::step)              \
      ->Arg(100000)                                                                       \
      ->Unit(benchmark::kMillisecond)                                                     \
      ->UseManualTime();                                                                  \
  BENCHMARK_CAPTURE(change_space_##side, lattice_##step, whole_cubic_lattice, Step::step) \
      ->Arg(100000)                                                                       \
      ->Unit(benchmark::kMillisecond)                                                     \
      ->UseManualTime()

THIESSEN_SPACE_CHANGE(ours, deletion);
THIESSEN_SPACE_CHANGE(cgal, deletion);
THIESSEN_SPACE_CHANGE(ours, insertion);
THIESSEN_SPACE_CHANGE(cgal, insertion);
BENCHMARK_CAPTURE(insert_space_ours, uniform_in_space, uniform_in_space)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(insert_space_ours, lattice, whole_cubic_lattice)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(change_space_ours, undo, uniform_in_space, Step::undo)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();

}  // namespace
}  // namespace thiessen
