#include "map/owners.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "earth/nearest_places.h"
#include "map/scanline.h"

namespace thiessen {
namespace {

/// The places at which a station reports, each with the first of them.
struct ReportingPlaces {
  std::vector<Point> positions;
  std::vector<std::int32_t> numbers;

  ReportingPlaces(const Network& network, const std::vector<bool>& reports) {
    for (std::uint32_t p = 0; p < network.places().size(); ++p) {
      for (const StationIndex s : network.stations_at(PlaceIndex{p})) {
        if (!reports[index(s)]) continue;
        positions.push_back(network.places()[p]);
        numbers.push_back(static_cast<std::int32_t>(index(s)) + 1);
        break;
      }
    }
  }
};

/// The pixels whose centres lie in one of the areas.
OwnerRaster pixels_within(const PixelGrid& grid, const std::vector<MultiPolygon>& areas) {
  OwnerRaster within(grid.columns, grid.rows);
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
    within.fill(rings, 1);
  }
  return within;
}

}  // namespace

std::vector<std::int32_t> owners(const PixelGrid& grid, const std::vector<MultiPolygon>& areas,
                                 const Network& network, Metric metric,
                                 const std::vector<bool>& reports,
                                 const std::function<ToStudy()>& to_study, unsigned threads) {
  const OwnerRaster within = pixels_within(grid, areas);
  const ReportingPlaces reporting(network, reports);
  const auto nearest_of = nearest_places(reporting.positions, metric);
  std::vector<std::int32_t> owners(within.owners().size(), 0);
  std::vector<ToStudy> transformations(std::max(1u, threads));
  in_parallel(static_cast<std::size_t>(grid.rows), threads, [&](std::size_t worker, std::size_t i) {
    const int row = static_cast<int>(i);
    if (!transformations[worker]) transformations[worker] = to_study();
    std::vector<int> columns;
    std::vector<Point> centres;
    for (int column = 0; column < grid.columns; ++column) {
      if (within.at(column, row) == OwnerRaster::nobody) continue;
      columns.push_back(column);
      centres.push_back(grid.centre(column, row));
    }
    transformations[worker](centres);
    PlaceIndex hint{0};
    std::vector<PlaceIndex> nearest;
    for (std::size_t c = 0; c < centres.size(); ++c) {
      if (!std::isfinite(centres[c].x) || !std::isfinite(centres[c].y)) continue;
      nearest_of->find(centres[c], hint, nearest);
      hint = nearest.front();
      std::int32_t number = reporting.numbers[index(hint)];
      for (const PlaceIndex p : nearest) number = std::min(number, reporting.numbers[index(p)]);
      owners[i * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(columns[c])] =
          number;
    }
  });
  return owners;
}

}  // namespace thiessen
