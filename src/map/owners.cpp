#include "map/owners.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/parallel.h"
#include "map/block_owners.h"
#include "map/scanline.h"

namespace thiessen {
namespace {

/// The places at which a station reports, each with the first of them, in the order of these.
struct ReportingPlaces {
  std::vector<Point> positions;
  std::vector<std::int32_t> numbers;

  ReportingPlaces(const Network& network, const std::vector<bool>& reports) {
    std::vector<bool> is_there(network.places().size(), false);
    for (std::uint32_t s = 0; s < reports.size(); ++s) {
      const std::size_t place = index(network.place_of(StationIndex{s}));
      if (!reports[s] || is_there[place]) continue;
      is_there[place] = true;
      positions.push_back(network.places()[place]);
      numbers.push_back(static_cast<std::int32_t>(s) + 1);
    }
  }
};

/// The pixels whose centres lie in one of the areas wait; others are 0.
std::vector<std::int32_t> waiting_pixels(const PixelGrid& grid,
                                         const std::vector<MultiPolygon>& areas) {
  OwnerRaster raster(grid.columns, grid.rows, 0);
  const auto in_pixels = [&](const Ring& ring) {
    Ring pixels;
    pixels.reserve(ring.size());
    for (const Point p : ring) {
      pixels.push_back(
          {(p.x - grid.north_west.x) / grid.pixel, (grid.north_west.y - p.y) / grid.pixel});
    }
    return pixels;
  };
  for (const MultiPolygon& area : areas) {
    std::vector<Ring> rings;
    for (const Polygon& part : area) {
      rings.push_back(in_pixels(part.outer));
      for (const Ring& hole : part.holes) rings.push_back(in_pixels(hole));
    }
    raster.fill(rings, BlockOwners::waiting);
  }
  return std::move(raster).take_owners();
}

/// The raster in squares, the last of a row or column narrower.
std::vector<PixelBlock> squares_of(const PixelGrid& grid) {
  constexpr int side = 128;
  std::vector<PixelBlock> squares;
  for (int row = 0; row < grid.rows; row += side) {
    for (int column = 0; column < grid.columns; column += side) {
      squares.push_back(
          {column, row, std::min(side, grid.columns - column), std::min(side, grid.rows - row)});
    }
  }
  return squares;
}

}  // namespace

std::vector<std::int32_t> owners(const PixelGrid& grid, const std::vector<MultiPolygon>& areas,
                                 const Network& network, Metric metric,
                                 const std::vector<bool>& reports,
                                 const std::function<PointMapping()>& to_study, unsigned threads) {
  const ReportingPlaces reporting(network, reports);
  if (reporting.positions.empty()) {
    return std::vector<std::int32_t>(
        static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), 0);
  }
  std::vector<std::int32_t> owners = waiting_pixels(grid, areas);
  const auto places = nearest_places(reporting.positions, metric);
  const std::vector<PixelBlock> squares = squares_of(grid);
  std::vector<std::unique_ptr<BlockOwners>> of_worker(std::max(1u, threads));
  in_parallel(squares.size(), threads, [&](std::size_t worker, std::size_t i) {
    auto& settling = of_worker[worker];
    if (!settling) {
      settling =
          std::make_unique<BlockOwners>(grid, *places, reporting.numbers, to_study(), owners);
    }
    settling->settle(squares[i]);
  });
  return owners;
}

}  // namespace thiessen
