// Normals of rasters over cells, against every pixel as a polygon: GEOS intersects, and areas are
// the surface's own.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "basin/cell_clipper.h"
#include "basin/shapes.h"
#include "diagram/surface.h"
#include "earth/area/ellipsoid_surface.h"
#include "geometry/seeded.h"
#include "oracles/geos.h"
#include "rainfall/network/weights.h"
#include "rainfall/normals/raster_normals.h"

namespace thiessen {
namespace {

/// A raster whose pixels begin at a corner, its rows running south.
struct Raster {
  Point corner;
  double side;
  std::size_t columns;
  std::size_t rows;

  Ring pixel(std::size_t row, std::size_t column) const {
    const double west = corner.x + static_cast<double>(column) * side;
    const double north = corner.y - static_cast<double>(row) * side;
    return shapes::rectangle({west, north - side}, {west + side, north});
  }
  AffineMapping mapping() const {
    return {{-corner.x / side, corner.y / side}, {1 / side, 0}, {0, -1 / side}};
  }
};

double ring_area(const Surface& surface, const GEOSGeometry* ring) {
  const GEOSCoordSequence* const points = GEOSGeom_getCoordSeq_r(geos::context(), ring);
  unsigned size = 0;
  GEOSCoordSeq_getSize_r(geos::context(), points, &size);
  Ring found(size);
  for (unsigned i = 0; i < size; ++i)
    GEOSCoordSeq_getXY_r(geos::context(), points, i, &found[i].x, &found[i].y);
  double area = 0;
  for (std::size_t i = 0; i + 1 < found.size(); ++i)
    area += surface.under(found[i], found[i + 1], found.front().y);
  return std::abs(area);
}

double area_on(const Surface& surface, const GEOSGeometry* shape) {
  double area = 0;
  for (int part = 0; part < GEOSGetNumGeometries_r(geos::context(), shape); ++part) {
    const GEOSGeometry* const g = GEOSGetGeometryN_r(geos::context(), shape, part);
    if (GEOSGeomTypeId_r(geos::context(), g) != GEOS_POLYGON) continue;
    if (GEOSisEmpty_r(geos::context(), g) == 1) continue;
    area += ring_area(surface, GEOSGetExteriorRing_r(geos::context(), g));
    for (int hole = 0; hole < GEOSGetNumInteriorRings_r(geos::context(), g); ++hole)
      area -= ring_area(surface, GEOSGetInteriorRingN_r(geos::context(), g, hole));
  }
  return area;
}

/// The mean of the pixels' values over a shape, each weighed by the area of its intersection.
double mean_by_pixels(const Raster& raster, const WindowValues& values, const MultiPolygon& shape,
                      const Surface& surface) {
  const geos::Geometry ground = geos::geometry_of(shape);
  double sum = 0;
  double whole = 0;
  for (std::size_t r = 0; r < raster.rows; ++r) {
    for (std::size_t c = 0; c < raster.columns; ++c) {
      const geos::Geometry pixel = geos::geometry_of({{raster.pixel(r, c), {}}});
      const double area = area_on(surface, geos::intersection(*ground, *pixel).get());
      whole += area;
      sum += area * values.at(0, r, c);
    }
  }
  return sum / whole;
}

void expect_means_of_pixels(Seeded& seeded, const Raster& raster, Metric metric) {
  const std::unique_ptr<Surface> surface = Yardstick{metric, 1, 0.1}.surface();
  const double wide = raster.side * static_cast<double>(raster.columns);
  const double high = raster.side * static_cast<double>(raster.rows);
  const Point middle{raster.corner.x + wide / 2, raster.corner.y - high / 2};
  WindowValues values(raster.columns, raster.rows, 1, true);
  for (std::size_t r = 0; r < raster.rows; ++r) {
    for (std::size_t c = 0; c < raster.columns; ++c) values.set(0, r, c, seeded.uniform(200, 2000));
  }
  std::vector<Station> stations;
  for (int i = 0; i < 12; ++i) {
    stations.push_back(
        {std::to_string(i),
         {raster.corner.x + seeded.uniform(0, wide), raster.corner.y - seeded.uniform(0, high)},
         0});
  }
  const Network network(stations, metric);
  const std::vector<Basin> basins{
      shapes::basin({{shapes::star(seeded, middle, 0.45 * std::min(wide, high), 17), {}}})};
  Weighing weighing(network, basins, {metric, 1, 0.1});
  std::unique_ptr<const PixelAreas> areas;
  if (metric == Metric::planar) {
    areas = std::make_unique<const EqualPixels>(raster.side * raster.side);
  } else {
    areas = std::make_unique<const PixelsInDegrees>(raster.corner.y, -raster.side, raster.side,
                                                    raster.rows);
  }
  std::vector<NormalWindow> windows;
  windows.push_back({PixelIntegrals(values, {1}, std::move(areas)),
                     std::make_unique<const AffineMapping>(raster.mapping())});
  const std::vector<std::vector<double>> gauges(stations.size(), {1});
  weighing.take_normals(std::make_shared<const RasterNormals>(
      gauges, std::move(windows), basins, std::vector<double>{weighing.basin_area(0)}));
  const ReportingStations all(stations.size(), true);
  const auto cells = weighing.cells(all, 1);
  ASSERT_FALSE(cells[0].empty());
  for (const StationCell& cell : cells[0]) {
    const double expected = mean_by_pixels(raster, values, cell.shape, *surface);
    // On the Earth the true edge and its chord are up to 0.1 m apart, and the judge sees chords.
    const double allowed = metric == Metric::planar ? 1e-9 : 1e-9 + 0.2 / std::sqrt(cell.area);
    EXPECT_NEAR(cell.factor, expected, allowed * expected) << cell.area;
  }
}

TEST(NormalsOfRasters, in_a_plane_are_those_of_every_pixel_as_a_polygon) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(4); ++round)
    expect_means_of_pixels(seeded, {{1000, 900}, 30, 21, 17}, Metric::planar);
}

TEST(NormalsOfRasters, in_degrees_are_those_of_every_pixel_as_a_polygon) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(4); ++round)
    expect_means_of_pixels(seeded, {{8, 47}, 0.25, 21, 17}, Metric::geodesic);
}

// Without curved edges nothing but the rounding is between the two: a basin with one gauge.
TEST(NormalsOfRasters, of_a_basin_in_degrees_are_those_of_every_pixel_to_1e_9) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(6); ++round) {
    const double side = round % 2 == 0 ? 0.02 : 0.5;
    const Raster raster{{-107, 41}, side, 19, 23};
    WindowValues values(raster.columns, raster.rows, 1, true);
    for (std::size_t r = 0; r < raster.rows; ++r) {
      for (std::size_t c = 0; c < raster.columns; ++c)
        values.set(0, r, c, seeded.uniform(200, 2000));
    }
    const Point middle{-107 + 9.5 * side, 41 - 11.5 * side};
    const Basin basin = shapes::basin({{shapes::star(seeded, middle, 9 * side, 21), {}}});
    const EllipsoidSurface surface;
    NormalWindow window{PixelIntegrals(values, {1},
                                       std::make_unique<const PixelsInDegrees>(
                                           raster.corner.y, -side, side, raster.rows)),
                        std::make_unique<const AffineMapping>(raster.mapping())};
    const RasterBasinNormals normals(std::move(window), basin, area_of(basin, surface));
    const double expected = mean_by_pixels(raster, values, basin.shape, surface);
    EXPECT_NEAR(normals.whole(0).mean, expected, 1e-9 * expected);
    EXPECT_EQ(normals.whole(0).covered, 1);
  }
}

}  // namespace
}  // namespace thiessen
