// Values at many silent gauges, beside those of the cells of the gauges that report.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "earth/sphere/geodesic.h"
#include "geometry/seeded.h"
#include "rainfall/areal_rainfall.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
constexpr Yardstick plane{Metric::planar, 1, 0.1};

struct GappyStep {
  std::vector<double> readings;
  ReportingStations reports;
};

/// Readings below 100, and a share of the gauges silent.
GappyStep gappy_step(Seeded& seeded, std::size_t stations, double share) {
  GappyStep step{std::vector<double>(stations, silent), ReportingStations(stations, false)};
  for (std::uint32_t s = 0; s < stations; ++s) {
    if (seeded.uniform(0, 1) < share) continue;
    step.readings[s] = seeded.uniform(0, 100);
    step.reports.set(StationIndex{s}, true);
  }
  return step;
}

double value_of(const BasinWeights& weights, std::span<const double> readings) {
  double sum = 0;
  for (const StationWeight& s : weights.stations) sum += s.weight * readings[index(s.station)];
  return sum;
}

/// The largest difference between values at many silent gauges and those of the cells that report,
/// on the Earth, in shares of the readings, which are below 100.
double worst_on_earth(Seeded& seeded, Point centre, double degrees, bool lattice, double share) {
  std::vector<Station> stations;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 12; ++j) {
      const double x = lattice ? (i - 6) / 6.0 : seeded.uniform(-1, 1);
      const double y = lattice ? (j - 6) / 6.0 : seeded.uniform(-1, 1);
      stations.push_back(
          {std::to_string(12 * i + j), {centre.x + degrees * x, centre.y + degrees * y}, 0});
    }
  }
  stations.push_back({"twin", stations[7].position, 0});
  const Network network(stations, Metric::geodesic);
  const std::vector<Basin> basins{
      shapes::basin({{shapes::star(seeded, centre, 0.9 * degrees, 40), {}}}),
      shapes::basin({{shapes::rectangle({centre.x - degrees, centre.y - degrees},
                                        {centre.x + 1.2 * degrees, centre.y + degrees}),
                      {}}})};
  // A tolerance at which chords make no difference.
  const Weighing weighing(network, basins, Yardstick{Metric::geodesic, 1, 1e-3 * degrees});
  const ArealRainfall rainfall(weighing, {}, 1);
  double worst = 0;
  for (int round = 0; round < 5; ++round) {
    const auto [readings, reports] = gappy_step(seeded, stations.size(), share);
    const auto expected = weighing.weights(reports, 1);
    const auto found = rainfall.at(readings);
    for (std::size_t b = 0; b < basins.size(); ++b) {
      const double sum = value_of(expected[b], readings);
      worst = std::max(worst, std::abs(found[b].rainfall - sum) / 100);
    }
  }
  return worst;
}

TEST(SilentGaugesOnTheEarth, have_the_values_of_the_network_without_them) {
  Seeded seeded;
  struct Place {
    Point centre;
    double degrees;
    double allowed;  // with the square of the gauges' distance over the Earth's radius
  };
  for (const Place& place : {Place{{10, 47}, 0.2, 2e-8}, Place{{179.9, -64}, 1, 1e-7},
                             Place{{-60, 2}, 5, 5e-7}, Place{{20, 84}, 3, 1e-6}}) {
    for (const bool lattice : {false, true}) {
      for (const double share : {0.05, 0.25, 0.6}) {
        EXPECT_LT(worst_on_earth(seeded, place.centre, place.degrees, lattice, share),
                  place.allowed)
            << place.centre.y << ' ' << place.degrees << ' ' << lattice << ' ' << share;
      }
    }
  }
}

// New edges lie where they should, to the tolerance, however far apart the gauges are: small basins
// on them tell by how much their weights are off.
TEST(SilentGaugesOnTheEarth, hand_over_along_edges_within_the_tolerance) {
  Seeded seeded;
  constexpr double tolerance = 0.1;
  for (const double spacing : {0.2, 1.0, 3.0, 8.0, 15.0}) {  // degrees
    std::vector<Station> stations;
    std::vector<double> readings;
    for (int i = -2; i <= 2; ++i) {
      for (int j = -2; j <= 2; ++j) {
        const Point at{20 + spacing * (i + seeded.uniform(-0.3, 0.3)),
                       30 + spacing * (j + seeded.uniform(-0.3, 0.3))};
        stations.push_back({std::to_string(stations.size()), at, 0});
        readings.push_back(i == 0 && j == 0 ? silent : seeded.uniform(0, 100));
      }
    }
    const Network network(stations, Metric::geodesic);
    std::vector<Basin> basins;
    constexpr double side = 500 / 111e3;  // degrees
    // Along the edges between those that report: where two are nearly as near.
    for (int tries = 0; basins.size() < 20 && tries < 2000000; ++tries) {
      const Point p{20 + spacing * seeded.uniform(-0.8, 0.8),
                    30 + spacing * seeded.uniform(-0.8, 0.8)};
      std::vector<double> distances;
      for (std::size_t s = 0; s < stations.size(); ++s) {
        if (!std::isnan(readings[s]))
          distances.push_back(geodesic_distance(p, stations[s].position));
      }
      std::sort(distances.begin(), distances.end());
      if (distances[1] - distances[0] > 300) continue;
      basins.push_back(shapes::basin({{shapes::rectangle(p, {p.x + side, p.y + side}), {}}}));
    }
    ASSERT_GE(basins.size(), 5u);
    const Weighing weighing(network, basins, Yardstick{Metric::geodesic, 1, tolerance});
    const Weighing fine(network, basins, Yardstick{Metric::geodesic, 1, 1e-3});
    const auto expected = fine.weights(reporting_stations(readings), 1);
    const auto found = ArealRainfall(weighing, {}, 1).weights_at(readings);
    for (std::size_t b = 0; b < basins.size(); ++b) {
      std::vector<double> difference(stations.size(), 0);
      for (const StationWeight& s : expected[b].stations) difference[index(s.station)] += s.weight;
      for (const StationWeight& s : found[b].stations) difference[index(s.station)] -= s.weight;
      for (const double d : difference) EXPECT_NEAR(d * 500, 0, tolerance) << spacing;
    }
  }
}

// At 60 % silent, on a lattice too, whole regions hand over together.
TEST(ManySilentGauges, have_the_values_of_the_network_without_them) {
  Seeded seeded;
  for (const bool lattice : {false, true}) {
    std::vector<Station> stations;
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 12; ++j) {
        const Point at =
            lattice ? Point{0.5 * i, 0.5 * j} : Point{seeded.uniform(0, 6), seeded.uniform(0, 6)};
        stations.push_back({std::to_string(12 * i + j), at, 0});
      }
    }
    const Network network(stations, Metric::planar);
    const std::vector<Basin> basins{shapes::basin({{shapes::star(seeded, {3, 3}, 2.9, 40), {}}}),
                                    shapes::basin({{shapes::rectangle({-1, -1}, {7, 7}), {}}})};
    const Weighing weighing(network, basins, plane);
    const ArealRainfall rainfall(weighing, {}, 1);
    for (int round = 0; round < 10; ++round) {
      const auto [readings, reports] = gappy_step(seeded, stations.size(), 0.6);
      const auto expected = weighing.weights(reports, 1);
      const auto found = rainfall.at(readings);
      for (std::size_t b = 0; b < basins.size(); ++b) {
        const double sum = value_of(expected[b], readings);
        EXPECT_NEAR(found[b].rainfall, sum, 1e-10) << lattice;
      }
    }
  }
}

}  // namespace
}  // namespace thiessen
