// The predicates where the filter decides, where the answer is zero, and where it is zero but for
// rounding.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/predicates.h"

namespace thiessen {
namespace {

using Corners = std::array<Point, 4>;

std::vector<Corners> random_sets(Point (*place)(std::mt19937_64&)) {
  std::mt19937_64 random(1);
  std::vector<Corners> sets;
  while (sets.size() < 1024) {
    Corners p;
    for (Point& q : p) q = place(random);
    const int side = orientation(p[0], p[1], p[2]);
    if (side == 0) continue;
    if (side < 0) std::swap(p[0], p[1]);
    sets.push_back(p);
  }
  return sets;
}

double uniform(std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(0, 1)(random);
}

Point anywhere(std::mt19937_64& random) {
  const double x = uniform(random);
  return {x, uniform(random)};
}

// Corners of the unit square at UTM offsets: always on one circle, half of the threes on no line.
Point of_a_square(std::mt19937_64& random) {
  return {500000.0 + static_cast<double>(random() % 2),
          4000000.0 + static_cast<double>(random() % 2)};
}

Point of_a_square_in_tenths(std::mt19937_64& random) {
  return {0.1 * static_cast<double>(7 + random() % 2), 0.1 * static_cast<double>(3 + random() % 2)};
}

Point nearly_on_a_circle(std::mt19937_64& random) {
  const double angle = 2 * M_PI * uniform(random);
  return {500000 + 1000 * std::cos(angle), 4000000 + 1000 * std::sin(angle)};
}

Point nearly_on_a_line(std::mt19937_64& random) {
  const double t = uniform(random);
  return {t, 0.3 * t};
}

Point on_a_line(std::mt19937_64& random) {
  const auto t = static_cast<double>(random() % 100000);
  return {500000 + t, 4000000 + 3 * t};
}

void in_circle_of(benchmark::State& state, Point (*place)(std::mt19937_64&)) {
  const std::vector<Corners> sets = random_sets(place);
  std::size_t i = 0;
  for (auto _ : state) {
    const Corners& p = sets[i++ % sets.size()];
    benchmark::DoNotOptimize(in_circle(p[0], p[1], p[2], p[3]));
  }
}

void orientation_of(benchmark::State& state, Point (*place)(std::mt19937_64&)) {
  std::mt19937_64 random(1);
  std::vector<Corners> sets(1024);
  for (Corners& p : sets) {
    for (Point& q : p) q = place(random);
  }
  std::size_t i = 0;
  for (auto _ : state) {
    const Corners& p = sets[i++ % sets.size()];
    benchmark::DoNotOptimize(orientation(p[0], p[1], p[2]));
  }
}

BENCHMARK_CAPTURE(in_circle_of, anywhere, anywhere);
BENCHMARK_CAPTURE(in_circle_of, a_square, of_a_square);
BENCHMARK_CAPTURE(in_circle_of, a_square_in_tenths, of_a_square_in_tenths);
BENCHMARK_CAPTURE(in_circle_of, points_nearly_on_a_circle, nearly_on_a_circle);
BENCHMARK_CAPTURE(orientation_of, anywhere, anywhere);
BENCHMARK_CAPTURE(orientation_of, points_on_a_line, on_a_line);
BENCHMARK_CAPTURE(orientation_of, points_nearly_on_a_line, nearly_on_a_line);

}  // namespace
}  // namespace thiessen
