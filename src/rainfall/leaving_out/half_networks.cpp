#include "rainfall/leaving_out/half_networks.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "base/interrupt.h"
#include "rainfall/leaving_out/gauge_groups.h"
#include "rainfall/methods/rain_methods.h"

namespace thiessen {
namespace {

PointMethod point_method(RainMethod method) {
  switch (method) {
    case RainMethod::thiessen:
      return PointMethod::thiessen;
    case RainMethod::arithmetic:
      return PointMethod::arithmetic;
    case RainMethod::idw:
      return PointMethod::idw;
    case RainMethod::natural:
      return PointMethod::natural;
    case RainMethod::isohyetal:
      break;
  }
  throw std::logic_error("isohyets weigh no gauges");
}

/// By station: in which half it is.
std::vector<std::size_t> halves_of(const Network& network) {
  std::vector<std::size_t> halves(network.stations().size());
  std::size_t number = 0;
  for (const PlaceIndex p : along_hilbert_curve(network)) {
    for (const StationIndex s : network.stations_at(p)) halves[index(s)] = number % 2;
    ++number;
  }
  return halves;
}

std::vector<double> half_of(std::span<const double> readings,
                            const std::vector<std::size_t>& halves, std::size_t half) {
  std::vector<double> left(readings.begin(), readings.end());
  for (std::size_t s = 0; s < left.size(); ++s) {
    if (halves[s] != half) left[s] = std::numeric_limits<double>::quiet_NaN();
  }
  return left;
}

ErrorSums errors_of(const StepRainfall& method, std::span<const HalvedStep> steps,
                    const std::vector<std::size_t>& halves) {
  ErrorSums errors;
  for (const HalvedStep& step : steps) {
    throw_if_interrupted();
    const StepRainfall& rainfall = step.month ? method.in_month(*step.month) : method;
    const std::vector<BasinRainfall> all = rainfall.at(step.readings);
    for (const std::size_t half : {0U, 1U}) {
      const auto of_half = rainfall.at(half_of(step.readings, halves, half));
      for (std::size_t b = 0; b < all.size(); ++b) {
        const double error = of_half[b].rainfall - all[b].rainfall;
        if (!std::isnan(error)) errors.add(error);
      }
    }
  }
  return errors;
}

}  // namespace

std::vector<HalvedMethod> errors_with_half_the_gauges(const Weighing& weighing,
                                                      std::span<const HalvedStep> steps,
                                                      std::size_t points, unsigned threads) {
  const Weighing without_normals(weighing.network(), weighing.basins(), weighing.yardstick());
  const std::vector<std::size_t> halves = halves_of(weighing.network());
  PointSettings settings;
  settings.points = points;
  ArealRainfallSettings values_alone;
  values_alone.accounts = false;
  Warnings told_elsewhere;
  std::vector<HalvedMethod> methods;
  for (const RainMethod method : all_methods) {
    for (const bool with_normals : {false, true}) {
      if (with_normals && weighing.normals() == nullptr) continue;
      const auto rainfall = rainfall_by({method}, with_normals ? weighing : without_normals,
                                        settings, values_alone, threads, told_elsewhere);
      methods.push_back({point_method(method), with_normals, errors_of(*rainfall, steps, halves)});
    }
  }
  return methods;
}

}  // namespace thiessen
