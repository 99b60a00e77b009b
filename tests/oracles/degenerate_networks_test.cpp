// Networks on the ellipsoid that rounding makes hard: gauges that differ in the last digits of
// their coordinates, and gauges on a grid of longitudes and latitudes, whose cells meet four in a
// point.
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "basin/cell_clipper.h"
#include "earth/area/ellipsoid_surface.h"
#include "earth/cells/geodesic_diagram.h"
#include "geometry/seeded.h"
#include "oracles/geos.h"

namespace thiessen {
namespace {

Basin box_basin(double west, double south, double east, double north) {
  return {"", {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}}, {}};
}

Box frame_of(const Basin& basin) {
  Box frame;
  for (const Point p : basin.shape[0].outer) frame.take_in(p);
  return frame;
}

std::vector<double> shares_of(const std::vector<Point>& places, const Basin& basin) {
  const Diagram diagram = geodesic_diagram(places, frame_of(basin), 0.05, 1e-6, 2);
  const EllipsoidSurface surface;
  CellClipper clipper(diagram, surface);
  std::vector<double> shares(places.size(), 0);
  for (const CellShare& share : clipper.shares(basin)) {
    shares[index(share.place)] = share.area / area_of(basin, surface);
  }
  return shares;
}

// Law: two gauges at nearly one place have together what one of them alone would have.
TEST(DegenerateNetworks, twins_at_any_distance_have_together_the_cell_of_one) {
  Seeded seeded;
  const Basin basin = box_basin(10, 46.7, 11.8, 48.1);
  // Edges cut at other nodes are drawn with other chords, 0.05 m from the true edge at most: 0.05 m
  // times 400 km of edges, of 2e10 square metres.
  const double chords = 1e-6;
  for (const double apart : {1.8e-15, 7e-15, 3e-14, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
    for (int round = 0; round < 20; ++round) {
      std::vector<Point> places;
      for (int i = 0; i < 12; ++i)
        places.push_back({seeded.uniform(9.5, 12.5), seeded.uniform(46.5, 48.5)});
      const std::vector<double> alone = shares_of(places, basin);
      const Point twin{places[0].x + apart * (round % 3 - 1), places[0].y + apart};
      if (twin == places[0]) continue;
      places.push_back(twin);
      const std::vector<double> together = shares_of(places, basin);
      EXPECT_NEAR(std::accumulate(together.begin(), together.end(), 0.0), 1, 1e-12) << apart;
      EXPECT_NEAR(together.front() + together.back(), alone.front(), 10 * apart + chords) << apart;
      for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        EXPECT_NEAR(together[i], alone[i], 10 * apart + chords) << apart << ' ' << i;
      }
    }
  }
}

struct Lattice {
  int side;
  double step;
  double west;
  double south;
};

// Gauge spacing by spacing: by symmetry the four gauges of a mesh are equally far from one point.
TEST(DegenerateNetworks, cells_of_gauges_on_a_grid_of_degrees_are_valid_and_have_no_slivers) {
  for (const Lattice lattice : {Lattice{20, 0.1, 10, 45}, Lattice{20, 0.25, -110, 60},
                                Lattice{20, 0.5, 0, -10}, Lattice{30, 0.05, 5, 45}}) {
    std::vector<Point> places;
    for (int i = 0; i < lattice.side; ++i) {
      for (int j = 0; j < lattice.side; ++j) {
        places.push_back({lattice.west + i * lattice.step, lattice.south + j * lattice.step});
      }
    }
    const double inner = 2.3 * lattice.step;
    const double far = (lattice.side - 3.3) * lattice.step;
    const Basin basin = box_basin(lattice.west + inner, lattice.south + inner, lattice.west + far,
                                  lattice.south + far);
    const Diagram diagram = geodesic_diagram(places, frame_of(basin), 0.05, 1e-6, 2);
    const EllipsoidSurface surface;
    CellClipper clipper(diagram, surface);
    const std::vector<ClippedCell> cells = clipper.cells(basin);
    const auto in_a_row = static_cast<std::size_t>(lattice.side - 4);
    EXPECT_EQ(cells.size(), in_a_row * in_a_row);
    double sum = 0;
    for (const ClippedCell& cell : cells) {
      EXPECT_EQ(geos::reason_invalid(*geos::geometry_of(cell.shape)), "");
      EXPECT_GT(cell.area, 1e-5 * area_of(basin, surface));
      sum += cell.area;
    }
    EXPECT_NEAR(sum / area_of(basin, surface), 1, 1e-12);
  }
}

}  // namespace
}  // namespace thiessen
