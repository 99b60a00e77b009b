// Changing the plane's tessellation point by point, beside CGAL's of the same points by the same
// operations: a deletion and an insertion with a hint, insertion without one, undoing, trying; and
// both without a hint once every point has given way to another, twice.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "benchmarks/point_sets.h"
#include "benchmarks/timer.h"
#include "tessellation/history.h"

namespace thiessen {
namespace {

using namespace benchmarks;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;
using HierarchyVertex =
    CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<Kernel>>;
using Hierarchy = CGAL::Triangulation_hierarchy_2<
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<HierarchyVertex>>>;
using Family = std::vector<Point> (*)(std::size_t);

template <typename Work>
void add_time_of(benchmark::State& state, std::size_t operations, Work&& work) {
  Timer timer;
  timer.start();
  work();
  timer.stop();
  count_operations(state, operations, timer);
}

std::vector<std::size_t> random_choices(std::size_t count, std::size_t of) {
  Generator g;
  std::vector<std::size_t> choices(count);
  for (std::size_t& c : choices) c = g.below(of);
  return choices;
}

constexpr std::size_t changes_at_once = 20000;

std::vector<Point> in_order(Family family, const benchmark::State& state) {
  std::vector<Point> points = family(static_cast<std::size_t>(state.range(0)));
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

PointId any_neighbour(const Tessellation<2>& tessellation, PointId p) {
  const auto& row = tessellation.topology().row(tessellation.topology().vertex_of(p));
  for (const PointId q : row.forming) {
    if (q != p && q != infinite_point) return q;
  }
  return p;
}

// A point is deleted and added again, from one of its neighbours; time of both.
void replace_ours(benchmark::State& state, Family family) {
  const std::vector<Point> points = in_order(family, state);
  Tessellation<2> tessellation;
  std::vector<PointId> numbers = tessellation.add_all(points);
  const auto choices = random_choices(changes_at_once, points.size());
  for (auto _ : state) {
    add_time_of(state, choices.size(), [&] {
      for (const std::size_t k : choices) {
        const PointId near = any_neighbour(tessellation, numbers[k]);
        tessellation.remove(numbers[k]);
        numbers[k] = tessellation.add(points[k], near);
      }
    });
  }
}

void replace_cgal(benchmark::State& state, Family family) {
  const std::vector<Point> points = in_order(family, state);
  std::vector<Kernel::Point_2> theirs;
  for (const Point p : points) theirs.emplace_back(p.x, p.y);
  Triangulation triangulation(theirs.begin(), theirs.end());
  std::vector<Triangulation::Vertex_handle> vertices;
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v)
    vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end(),
            [](auto a, auto b) { return a->point() < b->point(); });
  const auto choices = random_choices(changes_at_once, points.size());
  for (auto _ : state) {
    add_time_of(state, choices.size(), [&] {
      for (const std::size_t k : choices) {
        const auto face = vertices[k]->face();
        auto near = face->vertex(Triangulation::ccw(face->index(vertices[k])));
        if (triangulation.is_infinite(near))
          near = face->vertex(Triangulation::cw(face->index(vertices[k])));
        triangulation.remove(vertices[k]);
        vertices[k] = triangulation.insert(theirs[k], near->face());
      }
    });
  }
}

// A tenth more points, one by one, without a hint.
void insert_ours(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<Point> all = uniform(count + count / 10);
  const std::span<const Point> points(all);
  for (auto _ : state) {
    Tessellation<2> tessellation;
    tessellation.add_all(points.subspan(0, count));
    add_time_of(state, count / 10, [&] {
      for (const Point p : points.subspan(count)) tessellation.add(p);
    });
  }
}

void insert_cgal(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  std::vector<Kernel::Point_2> points;
  for (const Point p : uniform(count + count / 10)) points.emplace_back(p.x, p.y);
  for (auto _ : state) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(count);
    Hierarchy triangulation(points.begin(), first);
    add_time_of(state, count / 10, [&] {
      for (auto p = first; p != points.end(); ++p) triangulation.insert(*p);
    });
  }
}

enum class Step { make, undo, redo };

// Deletions and insertions with hints, by turns: made with history kept, undone, redone.
void with_history(benchmark::State& state, Step step) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<Point> points = uniform(count);
  const auto choices = random_choices(std::min(changes_at_once, count / 4), points.size());
  History<2> history;
  std::vector<PointId> numbers = history.add_all(points);
  const auto make = [&] {
    for (const std::size_t k : choices) {
      const PointId near = any_neighbour(history.tessellation(), numbers[k]);
      history.remove(numbers[k]);
      numbers[k] = history.add(points[k], near);
    }
  };
  const auto undo = [&] {
    for (std::size_t i = 0; i < 2 * choices.size(); ++i) history.undo();
  };
  const auto redo = [&] {
    for (std::size_t i = 0; i < 2 * choices.size(); ++i) history.redo();
  };
  for (auto _ : state) {
    if (step == Step::make) {
      add_time_of(state, 2 * choices.size(), make);
      undo();
    } else {
      make();
      if (step == Step::undo) {
        add_time_of(state, 2 * choices.size(), undo);
      } else {
        undo();
        add_time_of(state, 2 * choices.size(), redo);
        undo();
      }
    }
  }
}

// An insertion tried and taken back.
void try_insertion(benchmark::State& state) {
  const std::vector<Point> points = uniform(static_cast<std::size_t>(state.range(0)));
  Tessellation<2> tessellation;
  const std::vector<PointId> numbers = tessellation.add_all(points);
  Trial<2>::Changes changes;
  const auto choices = random_choices(changes_at_once, points.size());
  for (auto _ : state) {
    add_time_of(state, choices.size(), [&] {
      for (const std::size_t k : choices) {
        const Trial<2> trial(tessellation, changes);
        tessellation.add({points[k].x + 1e-9, points[k].y}, numbers[k]);
      }
    });
  }
}

enum class Ask { nearest, add };

// Every point is deleted and another comes, without a hint, until all have been replaced twice: are
// walks as short as at first?
void after_replacing_all_points(benchmark::State& state, Ask ask) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<Point> all = uniform(3 * count + changes_at_once);
  const std::span<const Point> points(all);
  Tessellation<2> tessellation;
  std::vector<PointId> numbers = tessellation.add_all(points.first(count));
  for (std::size_t i = count; i < 3 * count; ++i) {
    tessellation.remove(numbers[i % count]);
    numbers[i % count] = tessellation.add(points[i]);
  }
  const std::span<const Point> asked = points.last(changes_at_once);
  for (auto _ : state) {
    if (ask == Ask::nearest) {
      add_time_of(state, asked.size(), [&] {
        for (const Point p : asked) benchmark::DoNotOptimize(tessellation.nearest(p));
      });
    } else {
      Tessellation<2> copy = tessellation;
      add_time_of(state, asked.size(), [&] {
        for (const Point p : asked) benchmark::DoNotOptimize(copy.add(p));
      });
    }
  }
}

void after_replacing_all_points_cgal(benchmark::State& state, Ask ask) {
  const auto count = static_cast<std::size_t>(state.range(0));
  std::vector<Kernel::Point_2> points;
  for (const Point p : uniform(3 * count + changes_at_once)) points.emplace_back(p.x, p.y);
  Hierarchy triangulation;
  std::vector<Hierarchy::Vertex_handle> vertices;
  for (std::size_t i = 0; i < count; ++i) vertices.push_back(triangulation.insert(points[i]));
  for (std::size_t i = count; i < 3 * count; ++i) {
    triangulation.remove(vertices[i % count]);
    vertices[i % count] = triangulation.insert(points[i]);
  }
  const auto asked = std::span(points).last(changes_at_once);
  for (auto _ : state) {
    if (ask == Ask::nearest) {
      add_time_of(state, asked.size(), [&] {
        for (const auto& p : asked) benchmark::DoNotOptimize(triangulation.nearest_vertex(p));
      });
    } else {
      Hierarchy copy = triangulation;
      add_time_of(state, asked.size(), [&] {
        for (const auto& p : asked) benchmark::DoNotOptimize(copy.insert(p));
      });
    }
  }
}

#define THIESSEN_SIZES \
  Arg(1000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseManualTime()

BENCHMARK_CAPTURE(replace_ours, uniform, uniform)->THIESSEN_SIZES;
BENCHMARK_CAPTURE(replace_cgal, uniform, uniform)->THIESSEN_SIZES;
BENCHMARK_CAPTURE(replace_ours, utm_lattice, utm_lattice)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK_CAPTURE(replace_cgal, utm_lattice, utm_lattice)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime();
BENCHMARK(insert_ours)->THIESSEN_SIZES;
BENCHMARK(insert_cgal)->THIESSEN_SIZES;
BENCHMARK_CAPTURE(with_history, make, Step::make)->THIESSEN_SIZES;
BENCHMARK_CAPTURE(with_history, undo, Step::undo)->THIESSEN_SIZES;
BENCHMARK_CAPTURE(with_history, redo, Step::redo)->THIESSEN_SIZES;
BENCHMARK(try_insertion)->THIESSEN_SIZES;

#define THIESSEN_TWO_SIZES Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond)->UseManualTime()

BENCHMARK_CAPTURE(after_replacing_all_points, nearest, Ask::nearest)->THIESSEN_TWO_SIZES;
BENCHMARK_CAPTURE(after_replacing_all_points_cgal, nearest, Ask::nearest)->THIESSEN_TWO_SIZES;
BENCHMARK_CAPTURE(after_replacing_all_points, add, Ask::add)->THIESSEN_TWO_SIZES;
BENCHMARK_CAPTURE(after_replacing_all_points_cgal, add, Ask::add)->THIESSEN_TWO_SIZES;

}  // namespace
}  // namespace thiessen
