// Owners of 10,000 x 10,000 pixels for 1,000 and 100,000 stations, in the plane and on the Earth,
// beside the way in which they were found until cells were filled, which quarters blocks down to
// single pixels, and beside what only fills the same cells: cv::fillConvexPoly and
// GDALRasterizeGeometries, which are not exact along the edges. The cells are laid, and the places
// put in order, before the clock starts.
#include <benchmark/benchmark.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "diagram/plane_diagram.h"
#include "earth/nearest/nearest_places.h"
#include "geometry/box.h"
#include "map/raster/owners.h"
#include "map/raster/pixel_positions.h"

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

/// Stations and pixels in a square. On the Earth a pixel is a thousandth of a degree, from 42
/// degrees north on.
struct OwnerSquare {
  double south;
  double side;
  PixelGrid grid;
  std::vector<Point> stations;

  OwnerSquare(std::int64_t count, Metric metric) : stations(stations_in_pixels(count)) {
    const double pixel = metric == Metric::planar ? 1 : 1e-3;
    south = metric == Metric::planar ? 0 : 42;
    side = pixel * pixels_a_side;
    grid = {{0, south + side}, pixel, pixels_a_side, pixels_a_side};
    for (Point& p : stations) p = {pixel * p.x, south + pixel * p.y};
  }
};

void owners_alone(benchmark::State& state, Metric metric) {
  const auto [south, side, grid, positions] = OwnerSquare(state.range(0), metric);
  std::vector<Station> stations;
  for (const Point p : positions) stations.push_back({std::to_string(stations.size()), p, 0});
  const Network network(stations, metric);
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

/// Owners as they were found until cells were filled: blocks with several rivals are quartered.
class QuarteredBlocks {
 public:
  QuarteredBlocks(const PixelGrid& grid, const NearestPlaces& places, int rows)
      : grid_(grid),
        places_(places),
        owners_(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(rows)) {}

  std::span<const std::int32_t> rows(int row, int count) {
    constexpr int side = 128;
    first_row_ = row;
    for (int r = row; r < row + count; r += side) {
      for (int column = 0; column < grid_.columns; column += side) {
        const PixelBlock block{column, r, std::min(side, grid_.columns - column),
                               std::min(side, row + count - r)};
        const auto positions = PixelPositions::fit(
            grid_, block, [](std::vector<Point>&) {}, places_);
        places_.find_rivals(positions->ball(block), rivals_[0]);
        divide(*positions, block, 0);
      }
    }
    return owners_;
  }

 private:
  void divide(const PixelPositions& positions, const PixelBlock& block, std::size_t depth) {
    if (rivals_[depth].size() == 1) return fill(block, rivals_[depth].front());
    if (block.is_pixel()) {
      return fill(block, *places_.nearest(grid_.centre(block.column, block.row), rivals_[depth]));
    }
    const int west = (block.columns + 1) / 2;
    const int north = (block.rows + 1) / 2;
    for (const PixelBlock& quarter :
         {PixelBlock{block.column, block.row, west, north},
          PixelBlock{block.column + west, block.row, block.columns - west, north},
          PixelBlock{block.column, block.row + north, west, block.rows - north},
          PixelBlock{block.column + west, block.row + north, block.columns - west,
                     block.rows - north}}) {
      if (quarter.columns == 0 || quarter.rows == 0) continue;
      places_.keep_rivals(positions.ball(quarter), rivals_[depth], rivals_[depth + 1]);
      divide(positions, quarter, depth + 1);
    }
  }
  void fill(const PixelBlock& block, PlaceIndex place) {
    for (int row = block.row; row < block.row + block.rows; ++row) {
      const auto before =
          static_cast<std::ptrdiff_t>(row - first_row_) * grid_.columns + block.column;
      std::fill_n(owners_.begin() + before, block.columns,
                  static_cast<std::int32_t>(index(place)) + 1);
    }
  }

  const PixelGrid& grid_;
  const NearestPlaces& places_;
  int first_row_ = 0;
  std::vector<std::int32_t> owners_;
  std::array<std::vector<PlaceIndex>, 10> rivals_;  ///< by how often the block was quartered
};

void owners_by_quartering(benchmark::State& state, Metric metric) {
  const auto [south, side, grid, stations] = OwnerSquare(state.range(0), metric);
  const auto places = nearest_places(stations, metric);
  constexpr int band = 256;
  QuarteredBlocks blocks(grid, *places, band);
  for (auto _ : state) {
    for (int row = 0; row < grid.rows; row += band)
      benchmark::DoNotOptimize(blocks.rows(row, std::min(band, grid.rows - row)).data());
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
BENCHMARK_CAPTURE(owners_by_quartering, planar, Metric::planar)->Apply(stations_alone);
BENCHMARK_CAPTURE(owners_by_quartering, geodesic, Metric::geodesic)->Apply(stations_alone);
BENCHMARK(cells_by_opencv)->Apply(stations_alone);
BENCHMARK(cells_by_gdal)->Apply(stations_alone);

}  // namespace
}  // namespace thiessen
