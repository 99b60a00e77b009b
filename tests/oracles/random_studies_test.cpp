// Whole studies at random, as files give them: what is written of their cells is valid (by GEOS)
// and covers the basin once, its area is GeographicLib's, and weights add up to 1. Six thousand of
// them:
//   THIESSEN_ROUNDS=100 oracles_test --gtest_filter='RandomStudies.*'
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
#include "files/cells_file.h"
#include "files/study_files.h"
#include "gdal/crs/transformation.h"
#include "gdal/layers/layer.h"
#include "geometry/seeded.h"
#include "oracles/geos.h"
#include "rainfall/network/weights.h"

namespace thiessen {
namespace {

/// Where basins of a study may lie, and how large they may be.
struct Region {
  const char* crs;
  Point low;  ///< of their centres, in the unit of the CRS
  Point high;
  double largest;  ///< radius
};

constexpr Region regions[] = {
    {"EPSG:4326", {-179, -70}, {179, 70}, 15},
    {"EPSG:4326", {170, -60}, {190, 60}, 9},
    {"EPSG:32633", {3e5, 1e6}, {7e5, 8e6}, 2e5},
    {"EPSG:32760", {3e5, 2e6}, {7e5, 9e6}, 2e5},
    {"EPSG:3031", {-3e6, -3e6}, {3e6, 3e6}, 1e6},
    {"EPSG:3031", {-1e5, -1e5}, {1e5, 1e5}, 1e6},
    {"EPSG:3995", {-3e6, -3e6}, {3e6, 3e6}, 1e6},
    {"EPSG:3571", {-1e6, -1e6}, {1e6, 1e6}, 1e6},
    {"EPSG:6933", {-1.5e7, -5e6}, {1.5e7, 5e6}, 1e6},
    {"EPSG:3857", {-1.7e7, -1e7}, {1.7e7, 1e7}, 1e6},
};

/// A basin's parts, each valid by itself, none over another: its area is the sum of theirs.
struct Study {
  std::string crs;
  MultiPolygon parts;
  std::vector<Point> around;  ///< stations, in the CRS of the basin
  std::string what;           ///< what is odd about it, for messages
  double expected = 0;        ///< m2; 0: of the parts
};

Ring around(Point centre, double radius, int sides) {
  Ring ring;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return ring;
}

/// Adds a needle or a sliver: a detour from a vertex to a point outside and back, with a width from
/// nothing to a thousandth.
void add_needle(Seeded& seeded, Ring& ring, Point centre, double unit) {
  const std::size_t i = seeded.below(ring.size());
  const Point a = ring[i];
  const double out = seeded.uniform(1.02, 1.3);
  const Point tip{centre.x + out * (a.x - centre.x), centre.y + out * (a.y - centre.y)};
  const double width = unit * std::pow(10, seeded.uniform(-11, -3));
  const double length = std::hypot(a.x - centre.x, a.y - centre.y);
  const Point aside{-(a.y - centre.y) / length * width, (a.x - centre.x) / length * width};
  const Point half{(a.x + tip.x) / 2, (a.y + tip.y) / 2};
  const Point back{a.x + aside.x, a.y + aside.y};
  const Ring detour = seeded.below(2) == 0
                          ? Ring{tip, back}
                          : Ring{half, tip, {half.x + aside.x, half.y + aside.y}, back};
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1, detour.begin(), detour.end());
}

bool is_apart(const Polygon& a, const Polygon& b) {
  const geos::Geometry common =
      geos::intersection(*geos::geometry_of({a}), *geos::geometry_of({b}));
  return geos::area(*common) == 0;
}

/// How far a ring's edges keep from a point.
double clearance(const Ring& ring, Point centre) {
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    const Point along{b.x - a.x, b.y - a.y};
    const Point out{centre.x - a.x, centre.y - a.y};
    const double share = std::clamp(
        (out.x * along.x + out.y * along.y) / (along.x * along.x + along.y * along.y), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(out.x - share * along.x, out.y - share * along.y));
  }
  return nearest;
}

/// What may be odd about a basin. Each keeps the parts apart from each other but for shared edges.
void embellish(Seeded& seeded, Study& study, Point centre, double radius, double unit) {
  Polygon& first = study.parts.front();
  const double inner = std::min(radius / 5, 0.8 * clearance(first.outer, centre));
  switch (seeded.below(7)) {
    case 0: {
      study.what = "needles";
      const auto count = seeded.whole(1, 4);
      for (int i = 0; i < count; ++i) add_needle(seeded, first.outer, centre, unit);
      break;
    }
    case 1:
      study.what = "an island in a lake";
      first.holes.push_back(shapes::reversed(around(centre, inner, 7)));
      study.parts.push_back({around(centre, inner / 2, 5), {}});
      break;
    case 2:
      study.what = "an enclave that fills its hole";
      first.holes.push_back(shapes::reversed(around(centre, inner, 7)));
      study.parts.push_back({around(centre, inner, 7), {}});
      break;
    case 3: {
      study.what = "districts that share edges";
      const Ring whole = first.outer;
      study.parts.clear();
      for (std::size_t i = 0; i < whole.size(); ++i)
        study.parts.push_back({{centre, whole[i], whole[(i + 1) % whole.size()]}, {}});
      break;
    }
    case 4: {
      study.what = "an island that touches at a point, and another far off";
      const Point corner = first.outer[0];
      const Point out{corner.x + (corner.x - centre.x) / 4, corner.y + (corner.y - centre.y) / 4};
      const Point aside{(corner.y - centre.y) / 20, -(corner.x - centre.x) / 20};
      const Polygon island{{corner, {out.x + aside.x, out.y + aside.y}, out}, {}};
      if (is_apart(island, first)) study.parts.push_back(island);
      break;
    }
    case 5:
      study.what = "a lake with a sliver of land across";
      first.holes.push_back(
          shapes::reversed(shapes::rectangle({centre.x - inner, centre.y - inner / 2},
                                             {centre.x - unit * 1e-7, centre.y + inner / 2})));
      first.holes.push_back(shapes::reversed(shapes::rectangle(
          {centre.x, centre.y - inner / 2}, {centre.x + inner, centre.y + inner / 2})));
      break;
    default:
      study.what = "nothing";
  }
}

Study random_study(Seeded& seeded) {
  const Region& region = regions[seeded.below(std::size(regions))];
  const bool degrees = region.crs == regions[0].crs;
  const double unit = degrees ? 1e-5 : 1;  // about a metre
  Study study{region.crs, {}, {}, {}, 0};
  const Point centre{seeded.uniform(region.low.x, region.high.x),
                     seeded.uniform(region.low.y, region.high.y)};
  const double radius = region.largest * std::pow(10, seeded.uniform(degrees ? -4 : -4.5, 0)) / 1.3;
  study.parts.push_back(
      {shapes::star(seeded, centre, radius, static_cast<std::size_t>(seeded.whole(5, 30))), {}});
  embellish(seeded, study, centre, radius, unit);
  const auto stations = seeded.whole(1, 30);
  for (std::int64_t i = 0; i < stations; ++i)
    study.around.push_back({centre.x + radius * seeded.uniform(-1.1, 1.1),
                            centre.y + radius * seeded.uniform(-1.1, 1.1)});
  return study;
}

/// The area between a parallel and the nearer pole, by PolygonArea in steps along it.
double cap(double latitude) {
  const auto area = [&](int steps) {
    GeographicLib::PolygonArea polygon(GeographicLib::Geodesic::WGS84());
    for (int i = 0; i < steps; ++i) polygon.AddPoint(latitude, -180 + 360.0 * i / steps);
    double perimeter = 0;
    double inside = 0;
    polygon.Compute(false, true, perimeter, inside);
    return std::abs(inside);
  };
  const double coarse = area(2000);
  const double fine = area(4000);
  return fine + (fine - coarse) / 3;
}

/// A band of four corners, or a cap of four.
Study random_band(Seeded& seeded) {
  Study study{"EPSG:4326", {}, {}, "a band or a cap", 0};
  const double west = seeded.below(2) == 0 ? -180 : 0;
  const double south = seeded.uniform(-80, 60);
  const bool to_pole = seeded.below(2) == 0;
  const double north = to_pole ? 90 : seeded.uniform(south + 1, 85);
  study.parts = {{{{west, south}, {west + 360, south}, {west + 360, north}, {west, north}}, {}}};
  const double earth = GeographicLib::Geodesic::WGS84().EllipsoidArea();
  const auto north_of = [&](double latitude) {
    if (latitude == 90) return 0.0;
    return latitude > 0 ? cap(latitude) : earth - cap(latitude);
  };
  study.expected = north_of(south) - north_of(north);
  const auto stations = seeded.whole(1, 30);
  for (std::int64_t i = 0; i < stations; ++i)
    study.around.push_back({seeded.uniform(-180, 180), seeded.uniform(-89, 89)});
  return study;
}

/// Inside a ring with edges straight in `crs`, by PolygonArea on points along them.
double judged_area(const Ring& ring, const Transformation& to_degrees) {
  const auto area = [&](int pieces) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      for (int k = 0; k < pieces; ++k) {
        const double share = static_cast<double>(k) / pieces;
        points.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
      }
    }
    to_degrees.apply_unproved(points);
    GeographicLib::PolygonArea polygon(GeographicLib::Geodesic::WGS84());
    for (const Point p : points) polygon.AddPoint(p.y, p.x);
    double perimeter = 0;
    double inside = 0;
    polygon.Compute(false, true, perimeter, inside);
    return std::abs(inside);
  };
  const double coarse = area(60);
  const double fine = area(120);
  return fine + (fine - coarse) / 3;
}

double judged_area(const Study& study) {
  if (study.expected > 0) return study.expected;
  const Transformation to_degrees(Crs::from_text(study.crs, "a test"), Crs::wgs84());
  double sum = 0;
  for (const Polygon& part : study.parts) {
    sum += judged_area(part.outer, to_degrees);
    for (const Ring& hole : part.holes) sum -= judged_area(hole, to_degrees);
  }
  return sum;
}

std::string wkt_of(const Ring& ring) {
  std::string text = "(";
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Point p = ring[i % ring.size()];
    text += (i == 0 ? "" : ",") + shortest_text(p.x) + " " + shortest_text(p.y);
  }
  return text + ")";
}

std::string wkt_of(const MultiPolygon& shape) {
  std::string text = "MULTIPOLYGON(";
  for (const Polygon& part : shape) {
    text += (&part == &shape.front() ? "(" : ",(") + wkt_of(part.outer);
    for (const Ring& hole : part.holes) text += "," + wkt_of(hole);
    text += ")";
  }
  return text + ")";
}

StudyFiles read(const Study& study, double tolerance) {
  const TemporaryFolder folder;
  std::string stations = "id,x,y\n";
  for (std::size_t i = 0; i < study.around.size(); ++i)
    stations += std::to_string(i) + "," + shortest_text(study.around[i].x) + "," +
                shortest_text(study.around[i].y) + "\n";
  StudyRequest request;
  request.stations.source.file = folder.write("s.csv", stations);
  request.stations.source.crs = study.crs;
  request.basins.emplace();
  request.basins->source.file =
      folder.write("b.csv", "id,WKT\nb,\"" + wkt_of(study.parts) + "\"\n");
  request.basins->source.crs = study.crs;
  request.tolerance = tolerance;
  Warnings warnings;
  return read_study(request, warnings);
}

CellsOutput cells_of(const StudyFiles& study, const Weighing& weighing, double tolerance) {
  CellsOutput output;
  const ReportingStations all(weighing.network().stations().size(), true);
  const auto cells = weighing.cells(all, 1);
  for (const StationCell& cell : cells.at(0)) {
    CellFeature& feature = output.cells.emplace_back();
    feature.station = weighing.network().stations()[index(cell.station)].id;
    feature.basin = "b";
    feature.shape = cell.shape;
  }
  output.study_crs = study.crs;
  output.file_crs = study.output_crs();
  output.tolerance = tolerance;
  return output;
}

/// Every geometry of a file is valid, and none lies on another.
void expect_tiles(const std::string& file) {
  Layer layer(file, "", "");
  MultiPolygon together;
  double sum = 0;
  for (Row row; layer.next(row);) {
    MultiPolygon shape = layer.geometry().polygons;
    for (Polygon& part : shape) {
      part.outer.pop_back();
      for (Ring& hole : part.holes) hole.pop_back();
    }
    const geos::Geometry geometry = geos::geometry_of(shape);
    EXPECT_EQ(geos::reason_invalid(*geometry), "") << row.fields[0];
    sum += geos::area(*geometry);
    together.insert(together.end(), shape.begin(), shape.end());
  }
  EXPECT_GT(sum, 0);
  const geos::Geometry all = geos::geometry_of(together);
  const geos::Geometry united(GEOSUnaryUnion_r(geos::context(), all.get()));
  ASSERT_NE(united, nullptr);
  EXPECT_NEAR(geos::area(*united) / sum, 1, 1e-9);
}

void expect_right(const Study& study, double tolerance, bool geopackage) {
  SCOPED_TRACE(study.crs + ", " + study.what + ", tolerance " + shortest_text(tolerance));
  const StudyFiles files = read(study, tolerance);
  const Network network(files.stations, files.metric);
  const Weighing weighing(network, files.basins, {files.metric, 1, tolerance});
  const ReportingStations all(network.stations().size(), true);
  const auto weights = weighing.weights(all, 1);
  double sum = 0;
  for (const StationWeight& weight : weights.at(0).stations) sum += weight.weight;
  const double expected = judged_area(study);
  // Where an edge of the basin is cut, its point is rounded by a nanometre or so.
  EXPECT_NEAR(sum, 1, 1e-12 + 1e-8 / std::sqrt(expected));
  // A needle may have been collapsed that is narrower than a millimetre.
  const double needles = study.what == "needles" ? 4e-3 * std::sqrt(expected) : 0;
  EXPECT_NEAR(weighing.basin_area(0), expected, 3e-8 * expected + 0.1 + needles);
  const CellsOutput output = cells_of(files, weighing, tolerance);
  const TemporaryFolder folder;
  Warnings warnings;
  expect_tiles(folder.write("cells.geojson", cells_geojson(output, "cells.geojson", warnings)));
  if (!geopackage) return;
  for (const EncodedFile& file : cells_files(output, folder.path("cells.gpkg"), warnings))
    expect_tiles(folder.write("cells.gpkg", file.bytes));
}

TEST(RandomStudies, are_valid_cover_their_basins_and_have_GeographicLibs_area) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(60); ++round) {
    const Study study = seeded.below(8) == 0 ? random_band(seeded) : random_study(seeded);
    const double tolerance = std::pow(10, seeded.uniform(-3, 2));
    SCOPED_TRACE(testing::Message() << "round " << round);
    try {
      expect_right(study, tolerance, seeded.below(4) == 0);
    } catch (const std::exception& error) {
      ADD_FAILURE() << study.crs << ", " << study.what << ": " << error.what() << "\n"
                    << wkt_of(study.parts);
    }
  }
}

}  // namespace
}  // namespace thiessen
