// Compiled alone: the headers of other oracles hold another geodesic_distance.
// A raster's owners against the distances to all stations: Karney's, and in the plane rationals.
#include "map/raster/owners.h"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/PolarStereographic.hpp>
#include <GeographicLib/TransverseMercator.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "geometry/box.h"
#include "geometry/seeded.h"
#include "oracles/exact.h"

namespace thiessen {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
constexpr int side = 60;

using Projection = std::function<Point(Point)>;

struct Study {
  std::vector<Point> stations;
  PixelGrid grid;
  Projection to_study = [](Point p) { return p; };
};

std::vector<std::int32_t> owners_of(const Study& study, Metric metric) {
  std::vector<Station> stations;
  for (std::size_t i = 0; i < study.stations.size(); ++i) {
    stations.push_back({std::to_string(i), study.stations[i], 0});
  }
  const PixelGrid& grid = study.grid;
  const Point far = grid.at(grid.columns, grid.rows);
  const Ring all{grid.north_west, {grid.north_west.x, far.y}, far, {far.x, grid.north_west.y}};
  const ReportingStations report(stations.size(), true);
  const auto to_study = [&] {
    return [&](std::vector<Point>& points) {
      for (Point& p : points) p = study.to_study(p);
    };
  };
  Owners owners(grid, {{{all, {}}}}, Network(stations, metric), metric, report, to_study, 2);
  const std::span<const std::int32_t> rows = owners.rows(0, grid.rows);
  return {rows.begin(), rows.end()};
}

double geodesic_distance(Point a, Point b) {
  double metres = 0;
  GeographicLib::Geodesic::WGS84().Inverse(a.y, a.x, b.y, b.x, metres);
  return metres;
}

/// Every pixel's owner is nearest to 0.1 micrometres, and no station of a lower number is as near.
void expect_nearest_on_earth(const Study& study) {
  constexpr double noise = 3e-8;
  constexpr double equal = 5e-8;
  const std::vector<std::int32_t> found = owners_of(study, Metric::geodesic);
  std::size_t i = 0;
  for (int row = 0; row < study.grid.rows; ++row) {
    for (int column = 0; column < study.grid.columns; ++column) {
      const Point p = study.to_study(study.grid.centre(column, row));
      const std::int32_t owner = found[i++];
      if (!(std::abs(p.y) <= 90)) {
        ASSERT_EQ(owner, 0);
        continue;
      }
      ASSERT_GE(owner, 1);
      std::vector<double> distances;
      for (const Point station : study.stations) distances.push_back(geodesic_distance(p, station));
      const double least = *std::min_element(distances.begin(), distances.end());
      const auto number = static_cast<std::size_t>(owner);
      ASSERT_LE(distances[number - 1], least + equal + noise) << p.x << " " << p.y;
      for (std::size_t lower = 0; lower + 1 < number; ++lower) {
        ASSERT_GT(distances[lower], least + equal - noise) << p.x << " " << p.y << " " << lower;
      }
    }
  }
}

/// `size` pixels of a square around the point.
PixelGrid grid_round(Point centre, double half_width, double half_height) {
  PixelGrid grid;
  grid.pixel = 2 * half_width / side;
  grid.columns = side;
  grid.rows = std::max(1, static_cast<int>(std::lround(side * half_height / half_width)));
  grid.north_west = {centre.x - half_width, centre.y + grid.pixel * grid.rows / 2};
  return grid;
}

std::vector<Point> scattered(Seeded& seeded, std::uint64_t count, Point centre, double size) {
  std::vector<Point> stations;
  for (std::uint64_t i = 0; i < count; ++i) {
    stations.push_back({std::remainder(centre.x + size * seeded.uniform(-1, 1), 360),
                        std::clamp(centre.y + size * seeded.uniform(-1, 1), -90.0, 90.0)});
  }
  for (std::size_t i = 3; i < stations.size(); i += 7) stations[i] = stations[i - 3];
  return stations;
}

TEST(OwnersAgainstKarney, networks_of_a_metre_to_a_continent) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(25); ++round) {
    const double size = std::pow(10, seeded.uniform(-5, 1.7));
    const Point centre{seeded.uniform(-180, 180), seeded.uniform(-85, 85)};
    Study study;
    study.stations = scattered(seeded, 1 + seeded.below(40), centre, size);
    const double reach = size * seeded.uniform(0.3, 3);
    const double height = std::min(reach, 90 - std::abs(centre.y));
    study.grid = grid_round(centre, reach, height);
    expect_nearest_on_earth(study);
    if (HasFailure()) return;
  }
}

TEST(OwnersAgainstKarney, the_whole_earth_and_beyond_its_longitudes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(12); ++round) {
    const double size = round % 3 == 0 ? 180 : std::pow(10, seeded.uniform(-5, 1.5));
    Study study;
    study.stations = scattered(seeded, 1 + seeded.below(30),
                               {seeded.uniform(-180, 180), seeded.uniform(-90, 90)}, size);
    study.grid = grid_round({seeded.uniform(-180, 360), 0}, 180, 93);
    expect_nearest_on_earth(study);
    if (HasFailure()) return;
  }
}

TEST(OwnersAgainstKarney, antipodes_of_stations) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(12); ++round) {
    const Point centre{seeded.uniform(-180, 180), seeded.uniform(-80, 80)};
    const double size = std::pow(10, seeded.uniform(-4, 1));
    Study study;
    study.stations = scattered(seeded, 2 + seeded.below(10), centre, size);
    if (round % 2 == 0) {
      const Point first = study.stations.front();
      study.stations.push_back({std::remainder(first.x + 180, 360), -first.y});
    }
    study.grid = grid_round({centre.x + 180, -centre.y}, 1 + seeded.uniform(0, 9), 1);
    expect_nearest_on_earth(study);
    if (HasFailure()) return;
  }
}

TEST(OwnersAgainstKarney, lattices_have_exact_ties) {
  for (const Point corner : {Point{0, 0}, Point{-2, 40}, Point{178, -2}, Point{10, 86}}) {
    Study study;
    for (int i = 3; i >= 0; --i) {
      for (int j = 0; j < 5; ++j)
        study.stations.push_back({std::remainder(corner.x + j, 360), corner.y + i});
    }
    // Centres at whole sixteenths: halfway between two stations, and in the lattice at the equator
    // between four.
    study.grid.pixel = 1.0 / 8;
    study.grid.columns = study.grid.rows = 40;
    study.grid.north_west = {corner.x - 1.0 / 16, corner.y + 3 + 1.0 / 16};
    expect_nearest_on_earth(study);
    if (HasFailure()) return;
  }
}

TEST(OwnersAgainstKarney, a_ring_round_a_hub) {
  Study study;
  study.stations.push_back({10, 50});
  for (int i = 0; i < 300; ++i) {
    const double angle = 2 * M_PI * i / 300;
    double latitude = 0;
    double longitude = 0;
    GeographicLib::Geodesic::WGS84().Direct(50, 10, angle * 180 / M_PI, 150e3, latitude, longitude);
    study.stations.push_back({longitude, latitude});
  }
  study.grid = grid_round({10, 50}, 4, 3);
  expect_nearest_on_earth(study);
  study.stations.erase(study.stations.begin());
  expect_nearest_on_earth(study);
}

TEST(OwnersAgainstKarney, transverse_mercator) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(15); ++round) {
    const double size = std::pow(10, seeded.uniform(-4, 0.8));
    const Point centre{15 + seeded.uniform(-3, 3), seeded.uniform(-70, 70)};
    Study study;
    study.stations = scattered(seeded, 1 + seeded.below(40), centre, size);
    study.to_study = [](Point p) {
      Point there;
      GeographicLib::TransverseMercator::UTM().Reverse(15, p.x, p.y, there.y, there.x);
      return there;
    };
    Point middle;
    GeographicLib::TransverseMercator::UTM().Forward(15, centre.y, centre.x, middle.x, middle.y);
    study.grid = grid_round(middle, 1e5 * size, 1e5 * size);
    expect_nearest_on_earth(study);
    if (HasFailure()) return;
  }
}

TEST(OwnersAgainstKarney, polar_stereographic_over_the_pole) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(10); ++round) {
    const bool north = round % 2 == 0;
    Study study;
    study.stations = scattered(seeded, 1 + seeded.below(60), {0, north ? 75.0 : -75.0}, 15);
    for (Point& p : study.stations) p.x = seeded.uniform(-180, 180);
    if (round % 3 == 0) study.stations.push_back({77, north ? 90.0 : -90.0});
    study.to_study = [north](Point p) {
      Point there;
      GeographicLib::PolarStereographic::UPS().Reverse(north, p.x, p.y, there.y, there.x);
      return there;
    };
    const double reach = std::pow(10, seeded.uniform(4, 6.7));
    study.grid = grid_round({}, reach, reach);
    expect_nearest_on_earth(study);
    if (HasFailure()) return;
  }
}

// Orthographic, seen from the north, with a gore cut out: nothing beyond the horizon or in the
// gore.
TEST(OwnersAgainstKarney, projections_with_ends_and_gaps) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(4); ++round) {
    Study study;
    study.stations = scattered(seeded, 20, {0, 45}, 180);
    study.to_study = [](Point p) -> Point {
      const double radius = std::hypot(p.x, p.y);
      const double longitude = std::atan2(p.y, p.x) * 180 / M_PI;
      if (radius > 1 || (longitude > 20 && longitude < 35)) return {nowhere, nowhere};
      return {longitude < 20 ? longitude : longitude + 60, 90 - std::asin(radius) * 180 / M_PI};
    };
    study.grid = grid_round({}, 1.1, 1.1);
    expect_nearest_on_earth(study);
    if (HasFailure()) return;
  }
}

/// The first of the exactly nearest, in rationals.
void expect_nearest_in_plane(const Study& study) {
  using exactly::Rational;
  std::vector<exactly::Position> stations;
  for (const Point p : study.stations) stations.push_back(exactly::position(p));
  const std::vector<std::int32_t> found = owners_of(study, Metric::planar);
  std::size_t i = 0;
  for (int row = 0; row < study.grid.rows; ++row) {
    for (int column = 0; column < study.grid.columns; ++column) {
      const Point centre = study.to_study(study.grid.centre(column, row));
      const exactly::Position p = exactly::position(centre);
      std::int32_t first = 1;
      Rational least = exactly::square_distance(p, stations.front());
      for (std::size_t s = 1; s < stations.size(); ++s) {
        const Rational distance = exactly::square_distance(p, stations[s]);
        if (distance >= least) continue;
        least = distance;
        first = static_cast<std::int32_t>(s) + 1;
      }
      ASSERT_EQ(found[i++], first) << centre.x << " " << centre.y;
    }
  }
}

TEST(OwnersAgainstRationals, lattices_and_scattered_stations_of_any_size) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(30); ++round) {
    const double size = std::pow(10, seeded.uniform(-38, 47));
    const double away = round % 3 == 0 ? 0 : size * std::pow(10, seeded.uniform(0, 12));
    Study study;
    for (std::uint64_t k = 1 + seeded.below(20); k-- > 0;) {
      Point p{seeded.uniform(-1, 1), seeded.uniform(-1, 1)};
      if (round % 2 == 0) p = {std::round(3 * p.x) / 4, std::round(3 * p.y) / 4};
      study.stations.push_back({away + size * p.x, away + size * p.y});
    }
    study.grid = grid_round({away, away}, size, size * 0.5);
    if (round % 4 == 0) study.grid.pixel = size / 32;
    expect_nearest_in_plane(study);
    if (HasFailure()) return;
  }
}

TEST(OwnersAgainstRationals, whole_numbers_have_exact_ties) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(30); ++round) {
    const double offset = round % 2 == 0 ? 0 : 1e15;
    const std::int64_t most = 1 + seeded.whole(0, 30);
    Study study;
    for (int k = 0; k < 25; ++k) {
      study.stations.push_back({offset + static_cast<double>(seeded.whole(-most, most)),
                                offset + static_cast<double>(seeded.whole(-most, most))});
    }
    study.grid = {{offset - 20.25, offset + 20.25}, 0.5, 81, 61};
    expect_nearest_in_plane(study);
    if (HasFailure()) return;
  }
}

TEST(OwnersAgainstRationals, a_circle_of_stations_seen_from_its_middle) {
  Study study;
  // All points with whole coordinates on a circle of radius 5 * 13 * 17.
  constexpr int radius = 1105;
  for (int x = -radius; x <= radius; ++x) {
    for (int y = -radius; y <= radius; ++y) {
      if (x * x + y * y == radius * radius)
        study.stations.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  std::reverse(study.stations.begin(), study.stations.end());
  study.grid = {{-30.5, 30.5}, 1, 61, 61};
  expect_nearest_in_plane(study);
}

TEST(OwnersAgainstRationals, another_plane) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(10); ++round) {
    Study study;
    for (int k = 0; k < 20; ++k)
      study.stations.push_back({seeded.uniform(0, 7), seeded.uniform(0, 7)});
    study.to_study = [](Point p) -> Point {
      return {std::exp(p.x), p.y < 1.5 ? std::exp(p.y) : std::exp(p.y) / 2};
    };
    study.grid = grid_round({1, 1}, 1, 1);
    expect_nearest_in_plane(study);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen
