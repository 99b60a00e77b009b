// Weights of 10,000 stations in 1,000 basins of 50 vertices, beside GEOS: cells from its Voronoi
// diagram in an STRtree, each prepared basin intersected with the cells that meet it. And the same
// whole job for large networks: one basin of 10,000 vertices over a third of them, and 1,024 tiles
// that cover all of them.
#include <benchmark/benchmark.h>
#include <geos_c.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "rainfall/areal_rainfall.h"
#include "study/nearest_gauges.h"

namespace thiessen {
namespace {

struct Study {
  std::vector<Station> stations;
  std::vector<Basin> basins;
};

// In degrees within 10 by 10 of them, or metres within a million.
Study random_study(std::size_t stations, std::size_t basins, std::size_t vertices, bool degrees) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double size = degrees ? 10 : 1e6;
  const Point origin = degrees ? Point{-110, 35} : Point{0, 0};
  Study study;
  for (std::size_t i = 0; i < stations; ++i) {
    const double x = uniform(random);
    study.stations.push_back(
        {std::to_string(i), {origin.x + size * x, origin.y + size * uniform(random)}, 0});
  }
  for (std::size_t b = 0; b < basins; ++b) {
    const double x = uniform(random);
    const Point centre{origin.x + size * x, origin.y + size * uniform(random)};
    Ring ring;
    for (std::size_t k = 0; k < vertices; ++k) {
      const double angle = 2 * M_PI * static_cast<double>(k) / static_cast<double>(vertices);
      const double radius = 0.03 * size * (0.5 + 0.5 * uniform(random));
      ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    study.basins.push_back({std::to_string(b), {{ring, {}}}, {}});
  }
  return study;
}

/// One basin with a winding outline, over a third of the ground.
Study study_of_one_basin(std::size_t stations, bool degrees) {
  constexpr std::size_t vertices = 10000;
  Study study = random_study(stations, 0, 0, degrees);
  const double size = degrees ? 10 : 1e6;
  const Point centre = degrees ? Point{-105, 40} : Point{5e5, 5e5};
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  Ring ring;
  for (std::size_t k = 0; k < vertices; ++k) {
    const double angle = 2 * M_PI * static_cast<double>(k) / static_cast<double>(vertices);
    const double radius =
        size * (0.32 + 0.03 * std::sin(7 * angle) + 0.0003 * (uniform(random) - 0.5));
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  study.basins.push_back({"basin", {{ring, {}}}, {}});
  return study;
}

/// 32 by 32 square tiles over all the ground.
Study study_of_tiles(std::size_t stations, bool degrees) {
  constexpr int tiles = 32;
  Study study = random_study(stations, 0, 0, degrees);
  const double size = degrees ? 10 : 1e6;
  const Point origin = degrees ? Point{-110, 35} : Point{0, 0};
  const auto at = [&](int column, int row) {
    return Point{origin.x + size * column / tiles, origin.y + size * row / tiles};
  };
  for (int row = 0; row < tiles; ++row) {
    for (int column = 0; column < tiles; ++column) {
      const Ring ring{at(column, row), at(column + 1, row), at(column + 1, row + 1),
                      at(column, row + 1)};
      study.basins.push_back({std::to_string(row * tiles + column), {{ring, {}}}, {}});
    }
  }
  return study;
}

using MakeStudy = Study (*)(std::size_t stations, bool degrees);

Study basins_of_fifty(std::size_t stations, bool degrees) {
  return random_study(stations, 1000, 50, degrees);
}

void whole_ours(benchmark::State& state, Metric metric, MakeStudy make) {
  const Study study = make(static_cast<std::size_t>(state.range(0)), metric == Metric::geodesic);
  const ReportingStations all(study.stations.size(), true);
  for (auto _ : state) {
    const Network network(study.stations, metric);
    const Weighing weighing(network, study.basins, Yardstick{metric, 1, 0.1});
    benchmark::DoNotOptimize(weighing.weights(all, 1));
  }
}

void weights_ours(benchmark::State& state, Metric metric) {
  const Study study = basins_of_fifty(10000, metric == Metric::geodesic);
  const ReportingStations all(study.stations.size(), true);
  for (auto _ : state) {
    const Network network(study.stations, metric);
    const Weighing weighing(network, study.basins, Yardstick{metric, 1, 0.1});
    benchmark::DoNotOptimize(weighing.weights(all, static_cast<unsigned>(state.range(0))));
  }
}

void cells_ours(benchmark::State& state, Metric metric) {
  const Study study = random_study(10000, 1000, 50, metric == Metric::geodesic);
  const ReportingStations all(study.stations.size(), true);
  for (auto _ : state) {
    const Network network(study.stations, metric);
    const Weighing weighing(network, study.basins, Yardstick{metric, 1, 0.1});
    benchmark::DoNotOptimize(weighing.cells(all, static_cast<unsigned>(state.range(0))));
  }
}

GEOSGeometry* geos_polygon(GEOSContextHandle_t geos, const Ring& ring) {
  const auto size = static_cast<unsigned>(ring.size() + 1);
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos, size, 2);
  for (unsigned i = 0; i < size; ++i)
    GEOSCoordSeq_setXY_r(geos, sequence, i, ring[i % ring.size()].x, ring[i % ring.size()].y);
  return GEOSGeom_createPolygon_r(geos, GEOSGeom_createLinearRing_r(geos, sequence), nullptr, 0);
}

struct Search {
  GEOSContextHandle_t geos;
  const GEOSPreparedGeometry* prepared;
  const GEOSGeometry* basin;
  double area;
};

void add_area(void* item, void* data) {
  auto& search = *static_cast<Search*>(data);
  const auto* cell = static_cast<const GEOSGeometry*>(item);
  double area = 0;
  if (GEOSPreparedContains_r(search.geos, search.prepared, cell) == 1) {
    GEOSArea_r(search.geos, cell, &area);
  } else if (GEOSPreparedIntersects_r(search.geos, search.prepared, cell) == 1) {
    GEOSGeometry* common = GEOSIntersection_r(search.geos, search.basin, cell);
    GEOSArea_r(search.geos, common, &area);
    GEOSGeom_destroy_r(search.geos, common);
  }
  search.area += area;
}

void whole_geos(benchmark::State& state, MakeStudy make) {
  const Study study = make(static_cast<std::size_t>(state.range(0)), false);
  const GEOSContextHandle_t geos = GEOS_init_r();
  for (auto _ : state) {
    std::vector<GEOSGeometry*> points;
    for (const Station& s : study.stations)
      points.push_back(GEOSGeom_createPointFromXY_r(geos, s.position.x, s.position.y));
    GEOSGeometry* sites = GEOSGeom_createCollection_r(geos, GEOS_MULTIPOINT, points.data(),
                                                      static_cast<unsigned>(points.size()));
    GEOSGeometry* cells = GEOSVoronoiDiagram_r(geos, sites, nullptr, 0, 0);
    GEOSSTRtree* tree = GEOSSTRtree_create_r(geos, 10);
    const int count = GEOSGetNumGeometries_r(geos, cells);
    for (int i = 0; i < count; ++i) {
      const GEOSGeometry* cell = GEOSGetGeometryN_r(geos, cells, i);
      GEOSSTRtree_insert_r(geos, tree, cell, const_cast<GEOSGeometry*>(cell));
    }
    double sum = 0;
    for (const Basin& basin : study.basins) {
      GEOSGeometry* polygon = geos_polygon(geos, basin.shape[0].outer);
      const GEOSPreparedGeometry* prepared = GEOSPrepare_r(geos, polygon);
      Search search{geos, prepared, polygon, 0};
      GEOSSTRtree_query_r(geos, tree, polygon, add_area, &search);
      sum += search.area;
      GEOSPreparedGeom_destroy_r(geos, prepared);
      GEOSGeom_destroy_r(geos, polygon);
    }
    benchmark::DoNotOptimize(sum);
    GEOSSTRtree_destroy_r(geos, tree);
    GEOSGeom_destroy_r(geos, cells);
    GEOSGeom_destroy_r(geos, sites);
  }
  GEOS_finish_r(geos);
}

void weights_geos(benchmark::State& state) {
  whole_geos(state, basins_of_fifty);
}

// A step with a set of silent gauges not seen before, and one seen before.
void rainfall_step(benchmark::State& state, std::size_t remembered_bytes) {
  const Study study = random_study(400, 60, 50, true);
  const Network network(study.stations, Metric::geodesic);
  const Weighing weighing(network, study.basins, Yardstick{Metric::geodesic, 1, 0.1});
  const ArealRainfall rainfall(weighing, {Gaps::retessellate, 1, true, remembered_bytes}, 1);
  std::vector<double> readings(400, 1.5);
  for (std::size_t i = 0; i < readings.size(); i += 3) readings[i] = std::nan("");
  for (auto _ : state) benchmark::DoNotOptimize(rainfall.at(readings));
}

// What a study does to say which basins are far from all gauges, and the nearest gauge of each.
void gauges_of_tiles(benchmark::State& state, bool all_nearest) {
  const Study study = study_of_tiles(100000, true);
  std::vector<Point> places;
  for (const Station& station : study.stations) places.push_back(station.position);
  StudyParts parts;
  parts.metric = Metric::geodesic;
  const Ruler ruler(parts);
  const double diagonal = ruler.distance({-110, 45}, {-110 + 10 / 32., 45 - 10 / 32.});
  const std::vector<double> enough(all_nearest ? 0 : study.basins.size(), diagonal);
  for (auto _ : state)
    benchmark::DoNotOptimize(nearest_gauges(places, study.basins, ruler, enough));
}

BENCHMARK_CAPTURE(gauges_of_tiles, near_enough, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(gauges_of_tiles, nearest, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(weights_ours, planar, Metric::planar)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(weights_ours, geodesic, Metric::geodesic)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(cells_ours, planar, Metric::planar)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(cells_ours, geodesic, Metric::geodesic)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(weights_geos)->Arg(10000)->Unit(benchmark::kMillisecond);
// Each kind of study, ours and the peer's by turns.
BENCHMARK_CAPTURE(whole_ours, one_basin_geodesic, Metric::geodesic, study_of_one_basin)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_ours, one_basin_planar, Metric::planar, study_of_one_basin)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_geos, one_basin, study_of_one_basin)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_ours, tiles_geodesic, Metric::geodesic, study_of_tiles)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_ours, tiles_planar, Metric::planar, study_of_tiles)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(whole_geos, tiles, study_of_tiles)
    ->Arg(10000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(rainfall_step, new_set, std::size_t{0})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(rainfall_step, remembered_set, std::size_t{1} << 28)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace thiessen
