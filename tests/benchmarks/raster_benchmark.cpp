// A raster's owners for 1,000 stations: in the plane beside GDAL's grid of nearest neighbours, on
// the Earth in longitude and latitude and in UTM, and the same as a GeoTIFF.
#include <benchmark/benchmark.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "gdal/crs/crs.h"
#include "gdal/crs/transformation.h"
#include "gdal/rasters/raster_file.h"
#include "map/raster/owners.h"
#include "map/raster/step_pixels.h"

namespace thiessen {
namespace {

constexpr std::size_t station_count = 1000;

struct Square {
  Point south_west;
  double side;
};

constexpr Square plane{{0, 0}, 600e3};
constexpr Square degrees{{9, 42}, 10};
constexpr Square zone{{200e3, 4700e3}, 600e3};

std::vector<Point> stations_in(const Square& square) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, square.side);
  std::vector<Point> stations;
  for (std::size_t i = 0; i < station_count; ++i) {
    const double x = uniform(random);
    stations.push_back({square.south_west.x + x, square.south_west.y + uniform(random)});
  }
  return stations;
}

Network network_of(const std::vector<Point>& positions, Metric metric) {
  std::vector<Station> stations;
  for (const Point p : positions) stations.push_back({std::to_string(stations.size()), p, 0});
  return {std::move(stations), metric};
}

PixelGrid grid_of(const Square& square, std::int64_t pixels) {
  const int side = static_cast<int>(pixels);
  return {{square.south_west.x, square.south_west.y + square.side}, square.side / side, side, side};
}

std::vector<MultiPolygon> area_of(const Square& square) {
  const Point a = square.south_west;
  const Point b{a.x + square.side, a.y + square.side};
  return {{{{a, {b.x, a.y}, b, {a.x, b.y}}, {}}}};
}

/// 256 rows at a time, as they are written.
void make_all(Owners& owners, const PixelGrid& grid) {
  constexpr int band = 256;
  for (int row = 0; row < grid.rows; row += band)
    benchmark::DoNotOptimize(owners.rows(row, std::min(band, grid.rows - row)).data());
}

void owners_ours(benchmark::State& state, Metric metric, const Square& square) {
  const std::vector<Point> stations = stations_in(square);
  const PixelGrid grid = grid_of(square, state.range(0));
  const ReportingStations all(stations.size(), true);
  const auto same = [] { return [](std::vector<Point>&) {}; };
  for (auto _ : state) {
    Owners owners(grid, area_of(square), network_of(stations, metric), metric, all, same,
                  static_cast<unsigned>(state.range(1)));
    make_all(owners, grid);
  }
}

PointMapping from_zone() {
  return [transformation = std::make_shared<Transformation>(
              Crs::from_text("EPSG:32633", setting("crs")), Crs::wgs84())](
             std::vector<Point>& points) { transformation->apply_unproved(points); };
}

std::vector<Point> stations_in_zone() {
  std::vector<Point> stations = stations_in(zone);
  from_zone()(stations);
  return stations;
}

void owners_in_zone(benchmark::State& state) {
  const Network network = network_of(stations_in_zone(), Metric::geodesic);
  const PixelGrid grid = grid_of(zone, state.range(0));
  const ReportingStations all(station_count, true);
  for (auto _ : state) {
    Owners owners(grid, area_of(zone), network, Metric::geodesic, all, from_zone,
                  static_cast<unsigned>(state.range(1)));
    make_all(owners, grid);
  }
}

void geotiff_in_zone(benchmark::State& state) {
  const Network network = network_of(stations_in_zone(), Metric::geodesic);
  const PixelGrid grid = grid_of(zone, state.range(0));
  const ReportingStations all(station_count, true);
  const std::vector<std::string> ids(station_count, "id");
  const auto threads = static_cast<unsigned>(state.range(1));
  for (auto _ : state) {
    Owners owners(grid, area_of(zone), network, Metric::geodesic, all, from_zone, threads);
    RasterOutput output;
    output.grid = grid;
    output.crs = Crs::from_text("EPSG:32633", setting("crs"));
    output.path = "map.tif";
    output.threads = threads;
    benchmark::DoNotOptimize(owners_geotiff(
        output, [&](int row, int count) { return owners.rows(row, count); }, ids));
  }
}

/// Steps of a series in which 5 % of the gauges are silent at random: what a step costs, beside
/// writing it, on 1,000 x 1,000 pixels.
void steps(benchmark::State& state, Metric metric, const Square& square, bool in_zone) {
  const Network network = network_of(in_zone ? stations_in_zone() : stations_in(square), metric);
  const auto mapping = [&]() -> PointMapping {
    return in_zone ? from_zone() : [](std::vector<Point>&) {};
  };
  StepPixels pixels(grid_of(square, 1000), area_of(square), network, metric,
                    ReportingStations(station_count, true), mapping,
                    static_cast<unsigned>(state.range(0)));
  std::mt19937_64 random(1);
  std::bernoulli_distribution is_silent(0.05);
  std::vector<double> readings(station_count);
  for (auto _ : state) {
    for (double& reading : readings)
      reading = is_silent(random) ? std::numeric_limits<double>::quiet_NaN() : 1;
    benchmark::DoNotOptimize(pixels.at(readings).data());
  }
}

// Without a radius GDAL looks at all points for every pixel; with one, at those in it.
void nearest_gdal(benchmark::State& state, double radius) {
  const std::vector<Point> stations = stations_in(plane);
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> number;
  for (const Point p : stations) {
    x.push_back(p.x);
    y.push_back(p.y);
    number.push_back(static_cast<double>(number.size() + 1));
  }
  GDALGridNearestNeighborOptions options{};
  options.nSizeOfStructure = sizeof options;
  options.dfRadius1 = options.dfRadius2 = radius;
  const auto side = static_cast<GUInt32>(state.range(0));
  std::vector<std::int32_t> owners(static_cast<std::size_t>(side) * side);
  const double end = plane.side;
  for (auto _ : state) {
    GDALGridCreate(GGA_NearestNeighbor, &options, static_cast<GUInt32>(x.size()), x.data(),
                   y.data(), number.data(), 0, end, 0, end, side, side, GDT_Int32, owners.data(),
                   nullptr, nullptr);
    benchmark::DoNotOptimize(owners.data());
  }
}

BENCHMARK_CAPTURE(owners_ours, planar, Metric::planar, plane)
    ->Args({1000, 1})
    ->Args({4000, 1})
    ->Args({4000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(owners_ours, geodesic, Metric::geodesic, degrees)
    ->Args({1000, 1})
    ->Args({4000, 1})
    ->Args({4000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(owners_in_zone)
    ->Args({1000, 1})
    ->Args({4000, 1})
    ->Args({4000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(geotiff_in_zone)
    ->Args({4000, 1})
    ->Args({4000, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(steps, planar, Metric::planar, plane, false)
    ->Args({1})
    ->Args({2})
    ->Iterations(1000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(steps, geodesic, Metric::geodesic, degrees, false)
    ->Args({1})
    ->Args({2})
    ->Iterations(1000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(steps, in_zone, Metric::geodesic, zone, true)
    ->Args({1})
    ->Args({2})
    ->Iterations(1000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(nearest_gdal, all_points, 0.0)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(nearest_gdal, within_100_km, 100e3)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace thiessen
