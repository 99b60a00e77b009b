// What comes before inserting many points, and before inserting one: the order of insertion, beside
// CGAL's of the same points (which moves the points and has no rounds), and signposts.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/spatial_sort.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "geometry/insertion_order.h"
#include "geometry/signposts.h"

namespace thiessen {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

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

std::vector<Point> lattice(std::size_t count) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({0.1 * static_cast<double>(i % side), 0.1 * static_cast<double>(i / side)});
  }
  return points;
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

std::vector<Point> needle(std::size_t count) {
  Generator g;
  std::vector<Point> points(count);
  for (Point& p : points) p = {g.uniform(0, 1e-6), g.uniform(0, 1e6)};
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

std::vector<SpacePoint> in_space(std::size_t count) {
  Generator g;
  std::vector<SpacePoint> points(count);
  for (SpacePoint& p : points) p = {g.uniform(0, 1), g.uniform(0, 1), g.uniform(0, 1)};
  return points;
}

Kernel::Point_2 of_cgal(const Point& p) {
  return {p.x, p.y};
}
Kernel::Point_3 of_cgal(const SpacePoint& p) {
  return {p.x, p.y, p.z};
}

void count_points(benchmark::State& state, std::size_t count) {
  state.counters["a point"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

template <typename Family>
void order_ours(benchmark::State& state, Family family) {
  const auto points = family(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(insertion_order(points).data());
  count_points(state, points.size());
}

template <typename Family>
void order_cgal(benchmark::State& state, Family family) {
  const auto points = family(static_cast<std::size_t>(state.range(0)));
  std::vector<decltype(of_cgal(points[0]))> unsorted;
  for (const auto& p : points) unsorted.push_back(of_cgal(p));
  for (auto _ : state) {
    state.PauseTiming();
    auto sorted = unsorted;
    state.ResumeTiming();
    CGAL::spatial_sort(sorted.begin(), sorted.end(), Kernel());
    benchmark::DoNotOptimize(sorted.data());
  }
  count_points(state, points.size());
}

template <int Dimension>
auto numbered(const std::vector<PositionIn<Dimension>>& points) {
  std::vector<typename Signposts<Dimension>::Signpost> sample;
  for (const auto& p : points) sample.push_back({p, static_cast<std::uint32_t>(sample.size())});
  return sample;
}

template <int Dimension, typename Family>
void set(benchmark::State& state, Family family) {
  const auto sample = numbered<Dimension>(family(static_cast<std::size_t>(state.range(0))));
  Signposts<Dimension> signposts;
  for (auto _ : state) {
    signposts.set(sample);
    benchmark::DoNotOptimize(signposts.size());
  }
  count_points(state, sample.size());
}

// Positions of the sample itself are sought, so that each family is searched where it lies.
template <int Dimension, typename Family>
void near(benchmark::State& state, Family family) {
  const auto points = family(static_cast<std::size_t>(state.range(0)));
  Signposts<Dimension> signposts;
  signposts.set(numbered<Dimension>(points));
  std::mt19937_64 random(2);
  std::vector<PositionIn<Dimension>> sought;
  for (int i = 0; i < 65536; ++i) sought.push_back(points[random() % points.size()]);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(signposts.near(sought[i++ % sought.size()]));
}

constexpr auto set_in_plane = set<2, decltype(&uniform)>;
constexpr auto set_in_space = set<3, decltype(&in_space)>;
constexpr auto near_in_plane = near<2, decltype(&uniform)>;
constexpr auto near_in_space = near<3, decltype(&in_space)>;

#define THIESSEN_ORDER(family)                   \
  BENCHMARK_CAPTURE(order_ours, family, &family) \
      ->Arg(10000)                               \
      ->Arg(1000000)                             \
      ->Unit(benchmark::kMillisecond);           \
  BENCHMARK_CAPTURE(order_cgal, family, &family) \
      ->Arg(10000)                               \
      ->Arg(1000000)                             \
      ->Unit(benchmark::kMillisecond)

THIESSEN_ORDER(uniform);
THIESSEN_ORDER(lattice);
THIESSEN_ORDER(clusters);
THIESSEN_ORDER(needle);
THIESSEN_ORDER(road);
THIESSEN_ORDER(in_space);

BENCHMARK_CAPTURE(set_in_plane, signposts, &uniform)->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(set_in_space, signposts, &in_space)->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(near_in_plane, signposts, &uniform)->Arg(100)->Arg(10000);
BENCHMARK_CAPTURE(near_in_plane, signposts_in_clusters, &clusters)->Arg(10000);
BENCHMARK_CAPTURE(near_in_plane, signposts_in_a_needle, &needle)->Arg(10000);
BENCHMARK_CAPTURE(near_in_space, signposts, &in_space)->Arg(100)->Arg(10000);

}  // namespace
}  // namespace thiessen
