#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "basin/shapes.h"
#include "rainfall/methods/arithmetic_mean.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/method_rainfall.h"
#include "rainfall/methods/natural_neighbours.h"
#include "rainfall/textbook.h"

/// Studies for the methods other than the cells', and the rainfall that one of them gives.
namespace thiessen::by_method {

inline constexpr double silent = std::numeric_limits<double>::quiet_NaN();
inline constexpr Yardstick plane{Metric::planar, 1, 0.1};
inline constexpr Yardstick earth{Metric::geodesic, 1, 0.1};

struct Study {
  Study(std::vector<Station> stations, std::vector<Basin> areas, const Yardstick& yardstick)
      : network(std::move(stations), yardstick.metric),
        basins(std::move(areas)),
        weighing(network, basins, yardstick) {}

  Network network;
  std::vector<Basin> basins;
  Weighing weighing;
};

using Make = std::function<std::unique_ptr<const AreaMethod>(const Weighing&)>;
inline const Make arithmetic = [](const Weighing& w) {
  return std::make_unique<const ArithmeticMean>(w);
};
inline const Make idw = [](const Weighing& w) {
  return std::make_unique<const InverseDistance>(w, 300, 2);
};
inline const Make natural = [](const Weighing& w) {
  return std::make_unique<const NaturalNeighbours>(w, 300, 2);
};

/// The values of a step, whose account of weights is looked at, too.
inline std::vector<BasinRainfall> rainfall_of(const Study& study, const Make& make,
                                              const std::vector<double>& readings, Gaps gaps,
                                              std::size_t min_gauges = 1) {
  const MethodRainfall rainfall(study.weighing, make(study.weighing), {gaps, min_gauges});
  const auto values = rainfall.at(readings);
  const auto weights = rainfall.weights_at(readings);
  for (std::size_t b = 0; b < values.size(); ++b) {  // the account is that of the value
    double sum = 0;
    for (const StationWeight& s : weights[b].stations) sum += s.weight * readings[index(s.station)];
    if (weights[b].stations.empty()) {
      EXPECT_TRUE(std::isnan(values[b].rainfall));
    } else {
      EXPECT_NEAR(sum, values[b].rainfall, 1e-11 * (1 + std::abs(sum)));
      EXPECT_EQ(weights[b].stations.size(), values[b].gauges);
    }
  }
  return values;
}

inline Study textbook_study() {
  return {textbook::stations(), {textbook::basin()}, plane};
}

inline std::vector<Station> scattered(Seeded& seeded, std::size_t count, Point middle,
                                      double size) {
  std::vector<Station> stations;
  for (std::size_t i = 0; i < count; ++i) {
    stations.push_back(
        {std::to_string(i),
         {middle.x + seeded.uniform(-size, size), middle.y + seeded.uniform(-size, size)}});
  }
  return stations;
}

}  // namespace thiessen::by_method
