// Networks whose cells have borders along the antimeridian and corners at the poles: gauges on
// parallels, at even steps of longitude, all over the Earth or in caps and bands. What is written
// of their cells is judged by GEOS and by a closed formula of area, and by the same network seen in
// a mirror. A thousand of them, and as many images:
//   THIESSEN_ROUNDS=28 oracles_test --gtest_filter='SymmetricNetworks.*'
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/number.h"
#include "base/temporary_folder.h"
#include "basin/basin.h"
#include "files/cells_file.h"
#include "gdal/layers/layer.h"
#include "geometry/seeded.h"
#include "oracles/geos.h"
#include "study/study.h"

namespace thiessen {
namespace {

constexpr double radian = std::numbers::pi / 180;
constexpr double metres_a_degree = 111'320;

struct Symmetric {
  std::vector<Point> gauges;
  Ring basin;  ///< empty: the extent of the gauges
  double tolerance = 1;
};

double longitude(double x) {
  return x - 360 * std::floor((x + 180) / 360);
}

/// A box round the Earth, with vertices at every quarter.
Ring band(double south, double north) {
  Ring ring;
  for (int i = -2; i <= 2; ++i) ring.push_back({90.0 * i, south});
  for (int i = 2; i >= -2; --i) ring.push_back({90.0 * i, north});
  return ring;
}

Symmetric random_network(Seeded& seeded) {
  constexpr int counts[] = {2, 3, 4, 5, 6, 8};
  const int count = counts[seeded.below(std::size(counts))];
  const double step = 360.0 / count;
  // The antimeridian is between two gauges, at one, or neither.
  const double shifts[] = {-180 + step / 2, 0, -180, step / 4, 3.7};
  const double shift = shifts[seeded.below(std::size(shifts))];
  std::vector<double> latitudes;
  switch (seeded.below(5)) {
    case 0:
      latitudes = {0};
      break;
    case 1:
      latitudes = {5.0 * static_cast<double>(seeded.whole(1, 16))};
      break;
    case 2:
      latitudes = {-0.5 * static_cast<double>(seeded.whole(1, 160))};
      break;
    case 3:
      latitudes = {60, 70, 80};
      break;
    default:
      for (const double apart = 15.0 * static_cast<double>(seeded.whole(2, 4));
           const int k : {-1, 0, 1})
        latitudes.push_back(apart * k);
  }
  if (seeded.below(2) == 0) {
    for (double& latitude : latitudes) latitude = -latitude;
  }
  Symmetric network;
  for (const double latitude : latitudes) {
    for (int i = 0; i < count; ++i)
      network.gauges.push_back({longitude(shift + i * step), latitude});
  }
  if (seeded.below(8) == 0) network.gauges.push_back({0, 90});
  if (seeded.below(8) == 0) network.gauges.push_back({0, -90});
  // Gauges on the equator have no extent, and two meridians opposite each other that of either
  // side.
  const bool has_extent = count > 2 && latitudes != std::vector<double>{0};
  switch (seeded.below(5)) {
    case 0:
      if (!has_extent) network.basin = band(-30, 45);
      break;
    case 1:
      network.basin = band(-90, 90);
      break;
    case 2:
      network.basin = band(10.0 * static_cast<double>(seeded.whole(-8, 8)), 90);
      break;
    case 3:
      network.basin = band(-90, 10.0 * static_cast<double>(seeded.whole(-8, 8)));
      break;
    default:
      network.basin = band(-30, 45);
  }
  // Fine edges take a hundred times as long.
  const bool fine = seeded.below(50) == 0;
  network.tolerance =
      std::pow(10, static_cast<double>(fine ? seeded.whole(-2, 0) : seeded.whole(1, 4)));
  return network;
}

Symmetric mirrored(Symmetric network, bool east_west) {
  const auto mirror = [&](Point p) {
    return east_west ? Point{longitude(-p.x), p.y} : Point{p.x, -p.y};
  };
  std::transform(network.gauges.begin(), network.gauges.end(), network.gauges.begin(), mirror);
  for (Point& p : network.basin) p = east_west ? Point{-p.x, p.y} : Point{p.x, -p.y};
  std::reverse(network.basin.begin(), network.basin.end());
  return network;
}

std::string words(const Symmetric& network) {
  std::string text = "tolerance " + shortest_text(network.tolerance) + ", gauges";
  for (const Point p : network.gauges) text += " " + shortest_text(p.x) + "," + shortest_text(p.y);
  text += ", basin";
  for (const Point p : network.basin) text += " " + shortest_text(p.x) + " " + shortest_text(p.y);
  return text;
}

/// A study's cells, as they are written, by their gauges.
struct Written {
  MultiPolygon basin;
  std::map<std::string, MultiPolygon> shapes;
  std::map<std::string, double> areas;  ///< m2, of the weights
};

Written written(const Symmetric& network) {
  auto parts = std::make_shared<StudyParts>();
  parts->metric = Metric::geodesic;
  for (std::size_t i = 0; i < network.gauges.size(); ++i)
    parts->stations.push_back({std::to_string(i), network.gauges[i], i + 1});
  parts->has_basins = !network.basin.empty();
  if (parts->has_basins) parts->basins = {{"b", {{network.basin, {}}}, {}}};
  StudySettings settings;
  settings.tolerance = network.tolerance;
  Warnings warnings;
  const Study study(std::move(parts), settings, warnings);
  CellsOutput output;
  Written result;
  result.basin = study.basins().at(0).shape;
  const auto cells = study.weighing().cells(study.all_report(), 1);
  for (const StationCell& cell : cells.at(0)) {
    CellFeature& feature = output.cells.emplace_back();
    feature.station = study.network().stations()[index(cell.station)].id;
    feature.area = cell.area / 1e6;
    feature.shape = cell.shape;
    result.areas[feature.station] = cell.area;
  }
  output.study_crs = Crs::wgs84();
  output.file_crs = Crs::wgs84();
  output.tolerance = network.tolerance;
  const TemporaryFolder folder;
  Layer layer(folder.write("c.geojson", cells_geojson(output, "c.geojson", warnings)), "", "");
  for (Row row; layer.next(row);) {
    MultiPolygon& shape = result.shapes[std::string(row.fields[0])];
    shape = layer.geometry().polygons;
    for (Polygon& part : shape) {
      part.outer.pop_back();
      for (Ring& hole : part.holes) hole.pop_back();
    }
  }
  return result;
}

template <typename Visit>
void for_each_edge(const MultiPolygon& shape, const Visit& visit) {
  const auto ring = [&](const Ring& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
      visit(points[i], points[(i + 1) % points.size()]);
  };
  for (const Polygon& part : shape) {
    ring(part.outer);
    std::for_each(part.holes.begin(), part.holes.end(), ring);
  }
}

/// The area between a parallel and the equator, in m2 a radian of longitude (Snyder, Map
/// projections: a working manual, 1987, equation 3-12).
double to_equator(double latitude) {
  constexpr double a = 6378137;
  constexpr double f = 1 / 298.257223563;
  static const double e = std::sqrt(f * (2 - f));
  const double sine = std::sin(latitude * radian);
  const double q = sine / (1 - e * e * sine * sine) + std::atanh(e * sine) / e;
  return a * a * (1 - e * e) / 2 * q;
}

/// The area on the ellipsoid of a shape with edges straight in longitude and latitude, by Gauss and
/// Legendre's rule of five points in pieces of two degrees at the most.
double area_of(const MultiPolygon& shape) {
  constexpr std::pair<double, double> rule[] = {{0, 128.0 / 225},
                                                {0.5384693101056831, 0.47862867049936647},
                                                {-0.5384693101056831, 0.47862867049936647},
                                                {0.9061798459386640, 0.23692688505618908},
                                                {-0.9061798459386640, 0.23692688505618908}};
  double area = 0;
  for_each_edge(shape, [&](Point a, Point b) {
    const int pieces = 1 + static_cast<int>(std::abs(b.y - a.y) / 2);
    double mean = 0;
    for (int i = 0; i < pieces; ++i) {
      for (const auto& [at, weight] : rule)
        mean += weight / 2 * to_equator(a.y + (b.y - a.y) * (i + 0.5 + at / 2) / pieces) / pieces;
    }
    area -= (b.x - a.x) * radian * mean;
  });
  return area;
}

/// Metres round a shape, and what it has along the poles is nothing.
double perimeter_of(const MultiPolygon& shape) {
  double metres = 0;
  for_each_edge(shape, [&](Point a, Point b) {
    const double cosine = std::cos((a.y + b.y) / 2 * radian);
    metres += metres_a_degree * std::hypot((b.x - a.x) * cosine, b.y - a.y);
  });
  return metres;
}

void expect_laws(const Symmetric& network, const Written& cells) {
  MultiPolygon together;
  double sum = 0;
  for (const auto& [gauge, shape] : cells.shapes) {
    SCOPED_TRACE("the cell of " + gauge);
    const double area = cells.areas.at(gauge);
    ASSERT_FALSE(shape.empty()) << area;
    const geos::Geometry geometry = geos::geometry_of(shape);
    ASSERT_EQ(geos::reason_invalid(*geometry), "");
    sum += geos::area(*geometry);
    together.insert(together.end(), shape.begin(), shape.end());
    EXPECT_NEAR(area_of(shape), area, 2 * network.tolerance * perimeter_of(shape));
    for (const Polygon& part : shape) {
      EXPECT_GT(geos::area(*geos::geometry_of({part})), 0);
      double doubled = 0;
      for_each_edge({{part.outer, {}}}, [&](Point a, Point b) {
        doubled += a.x * b.y - b.x * a.y;
        EXPECT_LE(std::abs(a.x), 180);
        const bool at_pole = std::abs(a.y) == 90 && a.y == b.y;
        EXPECT_TRUE(std::abs(b.x - a.x) <= 180 || at_pole)
            << a.x << " " << a.y << " to " << b.x << " " << b.y;
      });
      EXPECT_GT(doubled, 0);
    }
  }
  const geos::Geometry all = geos::geometry_of(together);
  const geos::Geometry united(GEOSUnaryUnion_r(geos::context(), all.get()));
  ASSERT_NE(united, nullptr);
  EXPECT_NEAR(geos::area(*united) / sum, 1, 1e-9);
  const double basin = geos::area(*geos::geometry_of(cells.basin));
  EXPECT_NEAR(sum / basin, 1, 1e-9);
}

/// The shape in a mirror, as a valid geometry.
geos::Geometry mirror_image(MultiPolygon shape, bool east_west) {
  const auto turn = [&](Ring& ring) {
    for (Point& p : ring) p = east_west ? Point{-p.x, p.y} : Point{p.x, -p.y};
    std::reverse(ring.begin(), ring.end());
  };
  for (Polygon& part : shape) {
    turn(part.outer);
    std::for_each(part.holes.begin(), part.holes.end(), turn);
  }
  return geos::geometry_of(shape);
}

void expect_mirror_image(const Symmetric& network, const Written& cells, bool east_west) {
  SCOPED_TRACE(east_west ? "from east to west" : "from north to south");
  const Written image = written(mirrored(network, east_west));
  expect_laws(network, image);
  if (testing::Test::HasFailure()) return;
  ASSERT_EQ(image.areas.size(), cells.areas.size());
  for (const auto& [gauge, shape] : cells.shapes) {
    SCOPED_TRACE("the cell of " + gauge);
    const double area = cells.areas.at(gauge);
    EXPECT_NEAR(image.areas.at(gauge), area, 1e-9 * area + 10);
    const geos::Geometry here = geos::geometry_of(shape);
    const geos::Geometry there = mirror_image(image.shapes.at(gauge), east_west);
    const geos::Geometry apart(GEOSSymDifference_r(geos::context(), here.get(), there.get()));
    ASSERT_NE(apart, nullptr);
    // Near a pole a metre is many degrees of longitude.
    const double wide = 2 * network.tolerance / metres_a_degree;
    EXPECT_LT(geos::area(*apart), wide * (2000 + perimeter_of(shape) / metres_a_degree));
  }
}

TEST(SymmetricNetworks, are_written_whole_and_cover_the_basin_once_as_do_their_mirror_images) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(36); ++round) {
    const Symmetric network = random_network(seeded);
    SCOPED_TRACE("round " + std::to_string(round) + ": " + words(network));
    try {
      const Written cells = written(network);
      expect_laws(network, cells);
      if (!HasFailure()) expect_mirror_image(network, cells, seeded.below(2) == 0);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen
