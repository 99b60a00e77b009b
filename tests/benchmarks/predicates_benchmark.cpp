// The predicates where the filter decides, where the answer is zero, where it is zero but for
// rounding, and where scales are mixed: ours, and CGAL's with the same points.
#include "geometry/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>
#include <tuple>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "geometry/space_predicates.h"

namespace thiessen {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::size_t set_count = 1024;

double uniform(std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(0, 1)(random);
}
double either(std::mt19937_64& random, double a, double b) {
  return random() % 2 == 0 ? a : b;
}
double whole_below(std::mt19937_64& random, std::uint64_t end) {
  return static_cast<double>(random() % end);
}

Point anywhere(std::mt19937_64& random) {
  const double x = uniform(random);
  return {x, uniform(random)};
}
// Corners of a square at UTM offsets: always on one circle.
Point of_a_square(std::mt19937_64& random) {
  const double x = either(random, 500000, 500001);
  return {x, either(random, 4000000, 4000001)};
}
Point of_a_square_in_tenths(std::mt19937_64& random) {
  const double x = either(random, 500000.7, 500000.8);
  return {x, either(random, 4000000.3, 4000000.4)};
}
Point nearly_on_a_circle(std::mt19937_64& random) {
  const double angle = 2 * M_PI * uniform(random);
  return {500000 + 1000 * std::cos(angle), 4000000 + 1000 * std::sin(angle)};
}
Point nearly_on_the_unit_circle(std::mt19937_64& random) {
  const double angle = 2 * M_PI * uniform(random);
  return {std::cos(angle), std::sin(angle)};
}
// Corners of a rectangle of very different sides.
Point of_mixed_scales(std::mt19937_64& random) {
  const std::array<Point, 4> corners{{{1, 1e-20}, {-1, 1e-20}, {1, -1e-20}, {-1, -1e-20}}};
  return corners[random() % 4];
}
Point on_a_line(std::mt19937_64& random) {
  const double t = whole_below(random, 100000);
  return {500000 + t, 4000000 + 3 * t};
}
Point on_a_parallel(std::mt19937_64& random) {
  return {500000.1 + whole_below(random, 100000), 4000000.3};
}
Point nearly_on_a_line(std::mt19937_64& random) {
  const double t = uniform(random);
  return {t, 0.3 * t};
}

SpacePoint anywhere_in_space(std::mt19937_64& random) {
  const auto [x, y] = anywhere(random);
  return {x, y, uniform(random)};
}
SpacePoint of_a_cube(std::mt19937_64& random) {
  const auto [x, y] = of_a_square(random);
  return {x, y, either(random, 100, 101)};
}
SpacePoint of_a_cube_in_tenths(std::mt19937_64& random) {
  const auto [x, y] = of_a_square_in_tenths(random);
  return {x, y, either(random, 100.1, 100.2)};
}
SpacePoint nearly_on_a_sphere(std::mt19937_64& random) {
  const auto [x, y] = nearly_on_the_unit_circle(random);
  const double z = 2 * uniform(random) - 1;
  const double r = std::sqrt(1 - z * z);
  return {500000 + 1000 * r * x, 4000000 + 1000 * r * y, 1000 + 1000 * z};
}
SpacePoint of_a_cuboid_of_mixed_scales(std::mt19937_64& random) {
  const auto [x, y] = of_mixed_scales(random);
  return {x, y, either(random, -1, 1)};
}
SpacePoint on_a_plane(std::mt19937_64& random) {
  const double s = whole_below(random, 1000);
  const double t = whole_below(random, 1000);
  return {500000 + s, 4000000 + t, 100 + 2 * s - t};
}
SpacePoint on_a_level(std::mt19937_64& random) {
  const double s = whole_below(random, 1000);
  return {500000 + s, 4000000 + whole_below(random, 1000), 100};
}
SpacePoint nearly_on_a_plane(std::mt19937_64& random) {
  const double s = uniform(random);
  const double t = uniform(random);
  return {s, t, 0.3 * s + 0.7 * t};
}

Kernel::Point_2 theirs(const Point& p) {
  return {p.x, p.y};
}
Kernel::Point_3 theirs(const SpacePoint& p) {
  return {p.x, p.y, p.z};
}

template <std::size_t Count, class P>
std::vector<std::array<P, Count>> random_sets(P (*place)(std::mt19937_64&)) {
  std::mt19937_64 random(1);
  std::vector<std::array<P, Count>> sets(set_count);
  for (auto& set : sets) {
    for (P& p : set) p = place(random);
  }
  return sets;
}

/// Sets of different points whose first span a simplex that turns left.
template <std::size_t Count, class P>
std::vector<std::array<P, Count>> sets_round_simplices(P (*place)(std::mt19937_64&)) {
  std::mt19937_64 random(1);
  std::vector<std::array<P, Count>> sets;
  while (sets.size() < set_count) {
    std::array<P, Count> p;
    for (P& q : p) q = place(random);
    std::array<P, Count> sorted = p;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) continue;
    int side = 0;
    if constexpr (Count == 4) side = orientation(p[0], p[1], p[2]);
    if constexpr (Count == 5) side = orientation(p[0], p[1], p[2], p[3]);
    if (side == 0) continue;
    if (side < 0) std::swap(p[0], p[1]);
    sets.push_back(p);
  }
  return sets;
}

template <class Set, class Predicate>
void measure(benchmark::State& state, const std::vector<Set>& sets, Predicate predicate) {
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(std::apply(predicate, sets[i++ % set_count]));
}

template <class P, std::size_t Count, class Predicate>
void measure_theirs(benchmark::State& state, const std::vector<std::array<P, Count>>& sets,
                    Predicate predicate) {
  std::vector<std::array<decltype(theirs(P{})), Count>> converted(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (std::size_t k = 0; k < Count; ++k) converted[i][k] = theirs(sets[i][k]);
  }
  measure(state, converted, predicate);
}

using InPlane = Point (*)(std::mt19937_64&);
using InSpace = SpacePoint (*)(std::mt19937_64&);

void orientation_2(benchmark::State& state, InPlane place) {
  measure(state, random_sets<3>(place), [](const auto&... p) { return orientation(p...); });
}
void orientation_2_of_cgal(benchmark::State& state, InPlane place) {
  measure_theirs(state, random_sets<3>(place), Kernel().orientation_2_object());
}
void in_circle_2(benchmark::State& state, InPlane place) {
  measure(state, sets_round_simplices<4>(place), [](const auto&... p) { return in_circle(p...); });
}
void in_perturbed_circle_2(benchmark::State& state, InPlane place) {
  measure(state, sets_round_simplices<4>(place),
          [](const auto&... p) { return in_perturbed_circle(p...); });
}
void in_circle_2_of_cgal(benchmark::State& state, InPlane place) {
  measure_theirs(state, sets_round_simplices<4>(place),
                 Kernel().side_of_oriented_circle_2_object());
}
void circumcentre_2(benchmark::State& state, InPlane place) {
  measure(state, sets_round_simplices<4>(place),
          [](const auto& a, const auto& b, const auto& c, const auto&) {
            return circumcentre(a, b, c);
          });
}
void orientation_3(benchmark::State& state, InSpace place) {
  measure(state, random_sets<4>(place), [](const auto&... p) { return orientation(p...); });
}
void orientation_3_of_cgal(benchmark::State& state, InSpace place) {
  measure_theirs(state, random_sets<4>(place), Kernel().orientation_3_object());
}
void in_sphere_3(benchmark::State& state, InSpace place) {
  measure(state, sets_round_simplices<5>(place), [](const auto&... p) { return in_sphere(p...); });
}
void in_perturbed_sphere_3(benchmark::State& state, InSpace place) {
  measure(state, sets_round_simplices<5>(place),
          [](const auto&... p) { return in_perturbed_sphere(p...); });
}
void in_sphere_3_of_cgal(benchmark::State& state, InSpace place) {
  measure_theirs(state, sets_round_simplices<5>(place),
                 Kernel().side_of_oriented_sphere_3_object());
}
void circumcentre_3(benchmark::State& state, InSpace place) {
  measure(state, sets_round_simplices<5>(place),
          [](const auto& a, const auto& b, const auto& c, const auto& d, const auto&) {
            return circumcentre(a, b, c, d);
          });
}

// Ours and theirs, one after the other.
#define THIESSEN_AGAINST_CGAL(predicate, place) \
  BENCHMARK_CAPTURE(predicate, place, place);   \
  BENCHMARK_CAPTURE(predicate##_of_cgal, place, place)

THIESSEN_AGAINST_CGAL(orientation_2, anywhere);
THIESSEN_AGAINST_CGAL(orientation_2, on_a_parallel);
THIESSEN_AGAINST_CGAL(orientation_2, on_a_line);
THIESSEN_AGAINST_CGAL(orientation_2, nearly_on_a_line);
THIESSEN_AGAINST_CGAL(orientation_2, of_mixed_scales);
THIESSEN_AGAINST_CGAL(in_circle_2, anywhere);
THIESSEN_AGAINST_CGAL(in_circle_2, of_a_square);
THIESSEN_AGAINST_CGAL(in_circle_2, of_a_square_in_tenths);
THIESSEN_AGAINST_CGAL(in_circle_2, nearly_on_a_circle);
THIESSEN_AGAINST_CGAL(in_circle_2, nearly_on_the_unit_circle);
THIESSEN_AGAINST_CGAL(in_circle_2, of_mixed_scales);
BENCHMARK_CAPTURE(in_perturbed_circle_2, anywhere, anywhere);
BENCHMARK_CAPTURE(in_perturbed_circle_2, of_a_square, of_a_square);
BENCHMARK_CAPTURE(circumcentre_2, anywhere, anywhere);
BENCHMARK_CAPTURE(circumcentre_2, of_mixed_scales, of_mixed_scales);
THIESSEN_AGAINST_CGAL(orientation_3, anywhere_in_space);
THIESSEN_AGAINST_CGAL(orientation_3, on_a_level);
THIESSEN_AGAINST_CGAL(orientation_3, on_a_plane);
THIESSEN_AGAINST_CGAL(orientation_3, nearly_on_a_plane);
THIESSEN_AGAINST_CGAL(in_sphere_3, anywhere_in_space);
THIESSEN_AGAINST_CGAL(in_sphere_3, of_a_cube);
THIESSEN_AGAINST_CGAL(in_sphere_3, of_a_cube_in_tenths);
THIESSEN_AGAINST_CGAL(in_sphere_3, nearly_on_a_sphere);
THIESSEN_AGAINST_CGAL(in_sphere_3, of_a_cuboid_of_mixed_scales);
BENCHMARK_CAPTURE(in_perturbed_sphere_3, anywhere_in_space, anywhere_in_space);
BENCHMARK_CAPTURE(in_perturbed_sphere_3, of_a_cube, of_a_cube);
BENCHMARK_CAPTURE(circumcentre_3, anywhere_in_space, anywhere_in_space);
BENCHMARK_CAPTURE(circumcentre_3, of_a_cuboid_of_mixed_scales, of_a_cuboid_of_mixed_scales);

}  // namespace
}  // namespace thiessen
