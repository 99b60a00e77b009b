// Natural neighbours against CGAL's, and on the Earth against the ellipsoid's own cells.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/natural_neighbor_coordinates_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "basin/cell_clipper.h"
#include "earth/area/ellipsoid_surface.h"
#include "earth/sphere/geodesic.h"
#include "earth/yardstick.h"
#include "geometry/seeded.h"
#include "rainfall/methods/natural_weights.h"

namespace thiessen {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

TEST(NaturalWeights, are_those_of_cgal) {
  Seeded seeded;
  std::size_t compared = 0;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    std::vector<ChartPoint> gauges;
    const bool is_lattice = round % 2 == 0;
    for (int i = 0; i < 60; ++i) {
      const Point p{seeded.uniform(0, 10), seeded.uniform(0, 10)};
      gauges.push_back({is_lattice ? Point{std::round(p.x), std::round(p.y)} : p, {}});
    }
    NaturalWeights natural(gauges, ChartKind::plane);
    Triangulation triangulation;
    std::map<std::pair<double, double>, PointId> number;
    for (std::size_t i = 0; i < gauges.size(); ++i) {
      const Point p = gauges[i].at;
      triangulation.insert(Kernel::Point_2(p.x, p.y));
      number[{p.x, p.y}] = natural.numbers()[i];
    }
    std::vector<NaturalWeight> weights;
    for (int i = 0; i < 50; ++i) {
      const Point p{seeded.uniform(0, 10), seeded.uniform(0, 10)};
      std::vector<std::pair<Kernel::Point_2, Kernel::FT>> judge;
      const auto found = CGAL::natural_neighbor_coordinates_2(
          triangulation, Kernel::Point_2(p.x, p.y), std::back_inserter(judge));
      ASSERT_EQ(natural.find({p, {}}, weights), found.third);
      if (!found.third) continue;
      std::map<PointId, double> expected;
      for (const auto& [at, area] : judge)
        expected[number.at({CGAL::to_double(at.x()), CGAL::to_double(at.y())})] +=
            CGAL::to_double(area / found.second);
      for (const NaturalWeight& w : weights) {
        EXPECT_NEAR(w.weight, expected[w.gauge], 1e-13);
        expected.erase(w.gauge);
      }
      for (const auto& rest : expected) EXPECT_NEAR(rest.second, 0, 1e-13);
      ++compared;
    }
  }
  EXPECT_GT(compared, 300u);
}

/// The shares of the cell that a point would have on the ellipsoid, by the cells that they are
/// taken from; none where the cell leaves the frame.
std::vector<double> geodesic_weights(const std::vector<Point>& gauges, Point p, const Box& frame) {
  const Yardstick yardstick{Metric::geodesic, 1, 0.1};
  std::vector<Point> with = gauges;
  with.push_back(p);
  const Diagram diagram = yardstick.diagram(with, frame, 1);
  const EllipsoidSurface surface;
  CellClipper clipper(diagram, surface);
  const Ring ring{frame.low, {frame.high.x, frame.low.y}, frame.high, {frame.low.x, frame.high.y}};
  const auto cells = clipper.cells({"frame", {{ring, {}}}, {}});
  const Diagram before = yardstick.diagram(gauges, frame, 1);
  CellClipper taken(before, surface);
  for (const ClippedCell& cell : cells) {
    if (index(cell.place) != gauges.size()) continue;
    for (const Polygon& part : cell.shape) {
      for (const Point v : part.outer) {
        if (v.x == frame.low.x || v.x == frame.high.x || v.y == frame.low.y || v.y == frame.high.y)
          return {};
      }
    }
    std::vector<double> weights(gauges.size(), 0);
    for (const CellShare& share : taken.shares({"cell", cell.shape, {}}))
      weights[index(share.place)] = share.area / cell.area;
    return weights;
  }
  return {};
}

/// The largest difference of weights at some points among gauges over so many degrees.
double largest_difference(Seeded& seeded, Point middle, double degrees, int gauges_count) {
  std::vector<Point> gauges;
  const double stretch = 1 / std::cos(middle.y * M_PI / 180);
  const auto any = [&](double size) {
    return Point{middle.x + stretch * seeded.uniform(-size, size),
                 middle.y + seeded.uniform(-size, size)};
  };
  for (int i = 0; i < gauges_count; ++i) gauges.push_back(any(degrees / 2));
  const GaugeChart chart(gauges, Metric::geodesic);
  std::vector<ChartPoint> charted;
  for (const Point p : gauges) charted.push_back(chart.at(p));
  NaturalWeights natural(charted, chart.kind());
  const Box frame{{middle.x - stretch * degrees, middle.y - degrees},
                  {middle.x + stretch * degrees, middle.y + degrees}};
  double largest = 0;
  int compared = 0;
  std::vector<NaturalWeight> weights;
  for (int i = 0; i < 30; ++i) {
    const Point p = any(degrees / 3);
    if (!natural.find(chart.at(p), weights)) continue;
    std::vector<double> expected = geodesic_weights(gauges, p, frame);
    if (expected.empty()) continue;
    ++compared;
    for (const NaturalWeight& w : weights) {
      for (std::size_t g = 0; g < gauges.size(); ++g) {
        if (natural.numbers()[g] == w.gauge) expected[g] -= w.weight;
      }
    }
    for (const double rest : expected) largest = std::max(largest, std::abs(rest));
  }
  EXPECT_GT(compared, 10);
  return largest;
}

// The conformal sphere's scale changes, and with it areas and where the middle between two gauges
// is, by 5e-5 in 100 km at the most.
TEST(NaturalWeights, on_the_earth_are_the_stolen_areas_of_its_cells) {
  Seeded seeded;
  for (const Point middle : {Point{-105, 39}, Point{10, 0}, Point{179, -45}, Point{20, 72}}) {
    EXPECT_LT(largest_difference(seeded, middle, 0.5, 40), 3e-5);
    EXPECT_LT(largest_difference(seeded, middle, 6, 40), 1e-4);
    EXPECT_LT(largest_difference(seeded, middle, 14, 25), 5e-4);
  }
}

}  // namespace
}  // namespace thiessen
