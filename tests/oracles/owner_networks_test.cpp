// Every pixel of rasters over ten families of networks, in planes, on the Earth and over its poles,
// against the distances to all stations: exact ones in the plane, Karney's on the Earth.
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "earth/sphere/chord_bounds.h"
#include "geometry/predicates.h"
#include "geometry/seeded.h"
#include "map/raster/owners.h"
#include "rainfall/network/network.h"

namespace thiessen {
namespace {

constexpr int families = 10;

/// Stations in the unit square, or for the seventh family far outside of it.
std::vector<Point> family(Seeded& seeded, int which) {
  const auto anywhere = [&] { return Point{seeded.uniform(0, 1), seeded.uniform(0, 1)}; };
  std::vector<Point> stations;
  const auto add = [&](Point centre, Point offset, double size) {
    stations.push_back({centre.x + size * offset.x, centre.y + size * offset.y});
  };
  switch (which) {
    case 0:  // random
      for (std::uint64_t k = 5 + seeded.below(150); k-- > 0;) stations.push_back(anywhere());
      break;
    case 1: {  // a lattice
      const int side = static_cast<int>(seeded.whole(2, 9));
      for (int i = 0; i < side * side; ++i) {
        add({0, 0}, {static_cast<double>(i % side) + 0.5, static_cast<double>(i / side) + 0.5},
            1.0 / side);
      }
      break;
    }
    case 2: {  // on a line
      const Point direction = seeded.below(2) == 0 ? Point{1, 0} : anywhere();
      for (int i = 0; i < 12; ++i) add({0.01, 0.3}, direction, seeded.uniform(0, 1));
      break;
    }
    case 3:  // on a circle
      for (int i = 0; i < 24; ++i) {
        const double angle = 2 * M_PI * i / 24;
        add({0.5, 0.5}, {std::cos(angle), std::sin(angle)}, 0.375);
      }
      break;
    case 4:  // clusters
      for (int cluster = 0; cluster < 4; ++cluster) {
        const Point centre = anywhere();
        for (int i = 0; i < 10; ++i) add(centre, anywhere(), 2e-2);
      }
      break;
    case 5:  // each place three times
      for (int i = 0; i < 20; ++i) stations.push_back(anywhere());
      for (std::size_t i = 0; i < 40; ++i) stations.push_back(stations[(7 * i) % 20]);
      break;
    case 6: {  // far away
      const Point centre{seeded.uniform(2, 6), seeded.uniform(-1, 2)};
      for (int i = 0; i < 30; ++i) add(centre, anywhere(), 0.5);
      break;
    }
    case 7:  // one
      stations.push_back(anywhere());
      break;
    case 8:  // two
      stations = {anywhere(), anywhere()};
      break;
    default: {  // at tiny distances
      const Point centre = anywhere();
      const double size = std::pow(10, seeded.uniform(-8, -4));
      for (int i = 0; i < 8; ++i) add(centre, anywhere(), size);
      for (int i = 0; i < 3; ++i) stations.push_back(anywhere());
      break;
    }
  }
  return stations;
}

struct OwnerStudy {
  std::vector<Point> stations;
  PixelGrid grid;
  std::function<Point(Point)> to_study = [](Point p) { return p; };
};

Network network_of_owners(const OwnerStudy& study, Metric metric) {
  std::vector<Station> stations;
  for (const Point p : study.stations) stations.push_back({std::to_string(stations.size()), p, 0});
  return {std::move(stations), metric};
}

/// The owners, some rows at a time.
std::vector<std::int32_t> all_owners(const OwnerStudy& study, Metric metric, int at_once,
                                     unsigned threads) {
  const PixelGrid& grid = study.grid;
  const Point far = grid.at(grid.columns, grid.rows);
  const Ring all{grid.north_west, {grid.north_west.x, far.y}, far, {far.x, grid.north_west.y}};
  const auto mapping = [&] {
    return [&](std::vector<Point>& points) {
      for (Point& p : points) p = study.to_study(p);
    };
  };
  Owners owners(grid, {{{all, {}}}}, network_of_owners(study, metric), metric,
                ReportingStations(study.stations.size(), true), mapping, threads);
  std::vector<std::int32_t> found;
  for (int row = 0; row < grid.rows; row += at_once) {
    const auto rows = owners.rows(row, std::min(at_once, grid.rows - row));
    found.insert(found.end(), rows.begin(), rows.end());
  }
  return found;
}

void expect_exactly_nearest(const OwnerStudy& study, const std::vector<std::int32_t>& found) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto columns = static_cast<std::size_t>(study.grid.columns);
    const Point p = study.to_study(
        study.grid.centre(static_cast<int>(i % columns), static_cast<int>(i / columns)));
    std::size_t best = 0;
    for (std::size_t s = 1; s < study.stations.size(); ++s) {
      if (compare_distance(p, study.stations[s], study.stations[best]) < 0) best = s;
    }
    ASSERT_EQ(found[i], static_cast<std::int32_t>(best + 1)) << p.x << " " << p.y;
  }
}

/// Asks Karney for the distances to all stations' places (those within a micrometre share one) that
/// chords do not exclude by 2 %: geodesics and chords differ by less in their order.
void expect_nearest_by_geodesics(const OwnerStudy& study, const std::vector<std::int32_t>& found) {
  constexpr double equal = 5e-8;
  constexpr double noise = 3e-8;
  const Network network = network_of_owners(study, Metric::geodesic);
  std::vector<Point> places;
  for (std::uint32_t s = 0; s < study.stations.size(); ++s)
    places.push_back(network.places()[index(network.place_of(StationIndex{s}))]);
  std::vector<Direction> there;
  for (const Point p : places) there.push_back(on_ellipsoid(p));
  std::vector<double> squares(there.size());
  std::vector<double> distances(there.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto columns = static_cast<std::size_t>(study.grid.columns);
    const Point p = study.to_study(
        study.grid.centre(static_cast<int>(i % columns), static_cast<int>(i / columns)));
    const Direction from = on_ellipsoid(p);
    for (std::size_t s = 0; s < there.size(); ++s)
      squares[s] = dot(there[s] - from, there[s] - from);
    const double farthest = 1.04 * *std::min_element(squares.begin(), squares.end());
    double least = HUGE_VAL;
    for (std::size_t s = 0; s < there.size(); ++s) {
      distances[s] = HUGE_VAL;
      if (squares[s] > farthest) continue;
      const Point q = places[s];
      GeographicLib::Geodesic::WGS84().Inverse(p.y, p.x, q.y, q.x, distances[s]);
      least = std::min(least, distances[s]);
    }
    const auto number = static_cast<std::size_t>(found[i]);
    ASSERT_GE(number, 1U);
    ASSERT_LE(distances[number - 1], least + equal + noise) << p.x << " " << p.y;
    for (std::size_t lower = 0; lower + 1 < number; ++lower)
      ASSERT_GT(distances[lower], least + equal - noise) << p.x << " " << p.y << " " << lower;
  }
}

TEST(OwnersOfNetworks, planes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20); ++round) {
    const double size = std::pow(10, seeded.uniform(-3, 7));
    const Point corner{size * seeded.uniform(-9, 9), size * seeded.uniform(-9, 9)};
    OwnerStudy study;
    for (const Point p : family(seeded, static_cast<int>(round % families)))
      study.stations.push_back({corner.x + size * p.x, corner.y + size * p.y});
    study.grid = {{corner.x, corner.y + size}, size / 300, 300, 300};
    const auto found = all_owners(study, Metric::planar, 300, 2);
    expect_exactly_nearest(study, found);
    EXPECT_EQ(all_owners(study, Metric::planar, static_cast<int>(seeded.whole(1, 77)), 1), found);
    if (HasFailure()) FAIL() << "family " << round % families;
  }
}

TEST(OwnersOfNetworks, whole_numbers_in_planes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20); ++round) {
    OwnerStudy study;
    for (const Point p : family(seeded, static_cast<int>(round % families)))
      study.stations.push_back({std::round(64 * p.x), std::round(64 * p.y)});
    // Centres at whole quarters: many are exactly halfway.
    study.grid = {{-0.125, 64.125}, 0.25, 290, 270};
    expect_exactly_nearest(study, all_owners(study, Metric::planar, 270, 2));
    if (HasFailure()) FAIL() << "family " << round % families;
  }
}

TEST(OwnersOfNetworks, longitudes_and_latitudes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20); ++round) {
    const double size = std::pow(10, seeded.uniform(-3, 1.6));
    const Point corner{seeded.uniform(-180, 180), seeded.uniform(-80, 80 - size)};
    OwnerStudy study;
    for (const Point p : family(seeded, static_cast<int>(round % families))) {
      study.stations.push_back({std::remainder(corner.x + size * p.x, 360),
                                std::clamp(corner.y + size * p.y, -90.0, 90.0)});
    }
    study.grid = {{corner.x, corner.y + size}, size / 280, 280, 280};
    const auto found = all_owners(study, Metric::geodesic, 280, 2);
    expect_nearest_by_geodesics(study, found);
    EXPECT_EQ(all_owners(study, Metric::geodesic, static_cast<int>(seeded.whole(1, 77)), 1), found);
    if (HasFailure()) FAIL() << "family " << round % families;
  }
}

TEST(OwnersOfNetworks, poles) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20); ++round) {
    const bool north = round % 2 == 0;
    const double size = std::pow(10, seeded.uniform(3, 6.8));
    OwnerStudy study;
    study.to_study = [north](Point p) {
      Point there;
      GeographicLib::PolarStereographic::UPS().Reverse(north, p.x, p.y, there.y, there.x);
      return there;
    };
    for (const Point p : family(seeded, static_cast<int>(round % families)))
      study.stations.push_back(study.to_study({size * (p.x - 0.5), size * (p.y - 0.5)}));
    study.grid = {{-size / 2, size / 2}, size / 280, 280, 280};
    const auto found = all_owners(study, Metric::geodesic, 280, 2);
    expect_nearest_by_geodesics(study, found);
    if (HasFailure()) FAIL() << "family " << round % families;
  }
}

}  // namespace
}  // namespace thiessen
