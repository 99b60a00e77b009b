// Basins round the poles, read from files as users write them: their areas against GeographicLib's
// PolygonArea, and their cells against the basin.
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/PolygonArea.hpp>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/number.h"
#include "base/temporary_folder.h"
#include "basin/shapes.h"
#include "files/study_files.h"
#include "geometry/seeded.h"
#include "outlines/antimeridian.h"
#include "outlines/polygon_validity.h"
#include "rainfall/network/weights.h"

namespace thiessen {
namespace {

/// Inside a ring round a pole with edges straight in longitude and latitude, by PolygonArea, which
/// takes the smaller side of a ring that winds; in the limit for ever more geodesics an edge.
double judged_area(const Ring& ring) {
  const auto area = [&](int pieces) {
    GeographicLib::PolygonArea polygon(GeographicLib::Geodesic::WGS84());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      const double gain = std::remainder(b.x - a.x, 360);
      for (int k = 0; k < pieces; ++k) {
        const double share = static_cast<double>(k) / pieces;
        polygon.AddPoint(a.y + share * (b.y - a.y), a.x + share * gain);
      }
    }
    double perimeter = 0;
    double inside = 0;
    polygon.Compute(false, true, perimeter, inside);
    return std::abs(inside);
  };
  const double coarse = area(500);
  const double fine = area(1000);
  return fine + (fine - coarse) / 3;
}

/// Once round the Earth between two latitudes, a step at a time; sometimes back over the
/// antimeridian and on again.
Ring random_ring(Seeded& seeded, double low, double high) {
  Ring ring;
  // Fewer vertices would leave edges whose way round the Earth nobody knows.
  const auto vertices = static_cast<std::size_t>(seeded.whole(8, 30));
  for (std::size_t i = 0; i < vertices; ++i) {
    const double share =
        (static_cast<double>(i) + seeded.uniform(0, 0.9)) / static_cast<double>(vertices);
    ring.push_back({-179 + 358 * share, seeded.uniform(low, high)});
  }
  if (seeded.below(2) == 0) {
    const double step = (high - low) / 7;
    for (int i = 0; i < 6; ++i) {
      const double east = i % 4 < 2 ? 0 : -1;
      ring.push_back({east == 0 ? 179.5 : -179.5, low + step * (i + seeded.uniform(0.1, 0.9))});
    }
    // Over it, back, and over it again.
    ring.back().x = -179.5;
  }
  return ring;
}

/// The ring in another hemisphere, direction, with another first point, or in longitudes to 360.
Ring rewritten(Seeded& seeded, Ring ring, bool south) {
  for (Point& point : ring) point.y = south ? -point.y : point.y;
  if (seeded.below(2) == 0) std::reverse(ring.begin(), ring.end());
  std::rotate(ring.begin(),
              ring.begin() + seeded.whole(0, static_cast<std::int64_t>(ring.size()) - 1),
              ring.end());
  if (seeded.below(2) == 0) {
    for (Point& point : ring) point.x += point.x < 0 ? 360 : 0;
  }
  return ring;
}

std::string json_of(const Ring& ring) {
  std::string text = "[";
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Point point = ring[i % ring.size()];
    text += (i == 0 ? "[" : ",[") + shortest_text(point.x) + "," + shortest_text(point.y) + "]";
  }
  return text + "]";
}

std::string random_stations(Seeded& seeded) {
  std::string text = "id,lon,lat\n";
  const auto count = seeded.whole(1, 40);
  for (std::int64_t i = 0; i < count; ++i) {
    text += "s" + std::to_string(i) + "," + shortest_text(seeded.uniform(-180, 180)) + "," +
            shortest_text(seeded.uniform(-90, 90)) + "\n";
  }
  return text;
}

/// Weighs the stations in the one basin of a study, and looks at what is written of its cells.
void expect_cells_make_up_the_basin(const StudyFiles& study) {
  const Network network(study.stations, study.metric);
  const Weighing weighing(network, study.basins, {study.metric, 1, 1000});
  const ReportingStations all(network.stations().size(), true);
  double sum = 0;
  const auto weights = weighing.weights(all, 1);
  for (const StationWeight& weight : weights.at(0).stations) sum += weight.area;
  EXPECT_NEAR(sum / weighing.basin_area(0), 1, 1e-12);
  const auto cells = weighing.cells(all, 1);
  for (const StationCell& cell : cells.at(0)) {
    CurvedShape written{cell.shape, {}};
    cut_at_antimeridian(written);
    EXPECT_EQ(validity_fault(written.shape), "");
  }
}

StudyFiles study_of(const std::string& stations, const std::string& basins_name,
                    const std::string& basins, const std::string& basins_crs) {
  const TemporaryFolder folder;
  StudyRequest request;
  request.stations.source.file = folder.write("s.csv", stations);
  request.basins.emplace();
  request.basins->source.file = folder.write(basins_name, basins);
  request.basins->source.crs = basins_crs;
  request.tolerance = 1;
  Warnings warnings;
  return read_study(request, warnings);
}

double basin_area(const StudyFiles& study) {
  const Network network(study.stations, study.metric);
  return Weighing(network, study.basins, {study.metric, 1, 1000}).basin_area(0);
}

TEST(PolarBasins, have_the_area_that_GeographicLib_gives_them) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(40); ++round) {
    const double edge = seeded.uniform(5, 80);
    const double middle = seeded.uniform(edge, 85);
    const bool south = seeded.below(2) == 0;
    const bool band = seeded.below(2) == 0;
    const Ring outer = rewritten(seeded, random_ring(seeded, edge, middle), south);
    std::string rings = json_of(outer);
    double expected = judged_area(outer);
    if (band) {
      const Ring hole = rewritten(seeded, random_ring(seeded, middle, 89), south);
      rings += "," + json_of(hole);
      expected -= judged_area(hole);
    }
    const StudyFiles study = study_of(random_stations(seeded), "b.geojson",
                                      R"({"type":"Polygon","coordinates":[)" + rings + "]}", "");
    EXPECT_NEAR(basin_area(study) / expected, 1, 1e-8) << rings;
    expect_cells_make_up_the_basin(study);
  }
}

TEST(PolarBasins, in_an_equal_area_projection_have_the_planes_area) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(40); ++round) {
    const double radius = std::pow(10, seeded.uniform(5, 6.4));
    Point centre{seeded.uniform(-1, 1) * radius, seeded.uniform(-1, 1) * radius};
    Ring ring = shapes::star(seeded, centre, radius, 12);
    // The pole is a corner, or on an edge, or anywhere.
    const auto corner = seeded.below(ring.size());
    const Point a = ring[corner];
    const Point b = ring[(corner + 1) % ring.size()];
    const std::uint64_t how = seeded.below(3);
    const Point pole = how == 0 ? a : how == 1 ? Point{(a.x + b.x) / 2, (a.y + b.y) / 2} : Point{};
    std::string text;
    for (Point& point : ring) {
      point = {point.x - pole.x, point.y - pole.y};
      text += shortest_text(point.x) + " " + shortest_text(point.y) + ",";
    }
    text += shortest_text(ring[0].x) + " " + shortest_text(ring[0].y);
    const StudyFiles study = study_of(random_stations(seeded), "b.csv",
                                      "id,WKT\n1,\"POLYGON ((" + text + "))\"\n", "EPSG:3571");
    // PROJ's series for the authalic latitude is right to 1e-10.
    EXPECT_NEAR(basin_area(study) / plane_area({{ring, {}}}), 1, 1e-9) << how << " " << text;
    expect_cells_make_up_the_basin(study);
  }
}

}  // namespace
}  // namespace thiessen
