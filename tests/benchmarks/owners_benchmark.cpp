// Owners of 10,000 x 10,000 pixels for 1,000 and 100,000 stations, in the plane and on the Earth,
// beside what only fills the same cells: cv::fillConvexPoly and GDALRasterizeGeometries, which are
// not exact along the edges. The cells are laid before the clock starts.
#include <benchmark/benchmark.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <vector>

#include "diagram/plane_diagram.h"
#include "geometry/box.h"
#include "map/raster/owners.h"

namespace thiessen {
namespace {

constexpr int pixels_a_side = 10'000;

/// Stations in a square of as many units as there are pixels.
std::vector<Point> stations_in_pixels(std::int64_t count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, pixels_a_side);
  std::vector<Point> stations;
  for (std::int64_t i = 0; i < count; ++i) {
    const double x = uniform(random);
    stations.push_back({x, uniform(random)});
  }
  return stations;
}

/// The corners of each station's cell, counter-clockwise. Cells at the sides of the square go on
/// beyond it.
std::vector<std::vector<Point>> cells_of(const std::vector<Point>& stations) {
  const Diagram diagram =
      plane_diagram(stations, Box{{0, 0}, {1.0 * pixels_a_side, 1.0 * pixels_a_side}});
  std::vector<std::vector<Point>> cells(stations.size());
  for (const Chord& chord : diagram.chords) {
    for (const PlaceIndex place : {chord.left, chord.right}) {
      cells[index(place)].push_back(diagram.nodes[chord.from]);
      cells[index(place)].push_back(diagram.nodes[chord.to]);
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto angle = [&](Point p) {
      return std::atan2(p.y - stations[i].y, p.x - stations[i].x);
    };
    std::sort(cells[i].begin(), cells[i].end(),
              [&](Point a, Point b) { return angle(a) < angle(b); });
    cells[i].erase(std::unique(cells[i].begin(), cells[i].end()), cells[i].end());
  }
  return cells;
}

void owners_alone(benchmark::State& state, Metric metric) {
  // On the Earth a pixel is a thousandth of a degree, from 42 degrees north on.
  const bool is_plane = metric == Metric::planar;
  const double pixel = is_plane ? 1 : 1e-3;
  const double south = is_plane ? 0 : 42;
  const double side = pixel * pixels_a_side;
  std::vector<Station> stations;
  for (const Point p : stations_in_pixels(state.range(0)))
    stations.push_back({std::to_string(stations.size()), {pixel * p.x, south + pixel * p.y}, 0});
  const Network network(stations, metric);
  const PixelGrid grid{{0, south + side}, pixel, pixels_a_side, pixels_a_side};
  const Ring square{{0, south}, {side, south}, {side, south + side}, {0, south + side}};
  const auto same = [] { return [](std::vector<Point>&) {}; };
  Owners owners(grid, {{{square, {}}}}, network, metric, ReportingStations(stations.size(), true),
                same, static_cast<unsigned>(state.range(1)));
  constexpr int band = 256;
  for (auto _ : state) {
    for (int row = 0; row < grid.rows; row += band)
      benchmark::DoNotOptimize(owners.rows(row, std::min(band, grid.rows - row)).data());
  }
}

void cells_by_opencv(benchmark::State& state) {
  constexpr int fraction_bits = 8;
  std::vector<std::vector<cv::Point>> polygons;
  for (const std::vector<Point>& cell : cells_of(stations_in_pixels(state.range(0)))) {
    std::vector<cv::Point>& polygon = polygons.emplace_back();
    for (const Point p : cell) {
      polygon.emplace_back(static_cast<int>(std::lround((p.x - 0.5) * (1 << fraction_bits))),
                           static_cast<int>(std::lround((p.y - 0.5) * (1 << fraction_bits))));
    }
  }
  cv::Mat image(pixels_a_side, pixels_a_side, CV_32S, cv::Scalar(0));
  for (auto _ : state) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      cv::fillConvexPoly(image, polygons[i].data(), static_cast<int>(polygons[i].size()),
                         cv::Scalar(static_cast<double>(i + 1)), cv::LINE_8, fraction_bits);
    }
    benchmark::DoNotOptimize(image.data);
  }
}

void cells_by_gdal(benchmark::State& state) {
  GDALRegister_MEM();
  const std::unique_ptr<GDALDataset> image(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", pixels_a_side, pixels_a_side, 1, GDT_Int32, nullptr));
  double transform[6] = {0, 1, 0, 0, 0, 1};
  image->SetGeoTransform(transform);
  std::vector<std::unique_ptr<OGRPolygon>> polygons;
  std::vector<OGRGeometryH> geometries;
  std::vector<double> numbers;
  for (const std::vector<Point>& cell : cells_of(stations_in_pixels(state.range(0)))) {
    OGRLinearRing ring;
    for (const Point p : cell) ring.addPoint(p.x, p.y);
    ring.closeRings();
    polygons.push_back(std::make_unique<OGRPolygon>());
    polygons.back()->addRing(&ring);
    geometries.push_back(OGRGeometry::ToHandle(polygons.back().get()));
    numbers.push_back(static_cast<double>(numbers.size() + 1));
  }
  int band = 1;
  for (auto _ : state) {
    GDALRasterizeGeometries(GDALDataset::ToHandle(image.get()), 1, &band,
                            static_cast<int>(geometries.size()), geometries.data(), nullptr,
                            nullptr, numbers.data(), nullptr, nullptr, nullptr);
  }
}

void stations_and_threads(benchmark::internal::Benchmark* all) {
  for (const std::int64_t stations : {1'000, 100'000}) {
    for (const std::int64_t threads : {1, 2}) all->Args({stations, threads});
  }
  all->Unit(benchmark::kMillisecond)->UseRealTime();
}

void stations_alone(benchmark::internal::Benchmark* all) {
  for (const std::int64_t stations : {1'000, 100'000}) all->Arg(stations);
  all->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK_CAPTURE(owners_alone, planar, Metric::planar)->Apply(stations_and_threads);
BENCHMARK_CAPTURE(owners_alone, geodesic, Metric::geodesic)->Apply(stations_and_threads);
BENCHMARK(cells_by_opencv)->Apply(stations_alone);
BENCHMARK(cells_by_gdal)->Apply(stations_alone);

}  // namespace
}  // namespace thiessen
