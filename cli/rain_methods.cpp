#include "cli/rain_methods.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/methods/arithmetic_mean.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/method_rainfall.h"
#include "rainfall/methods/natural_neighbours.h"

namespace thiessen::cli {
namespace {

void warn_of_hull(const std::vector<double>& outside, const std::vector<Basin>& basins,
                  Warnings& warnings) {
  const auto most = std::max_element(outside.begin(), outside.end());
  const auto count = std::count_if(outside.begin(), outside.end(), [](double s) { return s > 0; });
  if (count == 0) return;
  std::string share;
  append_fixed(share, 100 * *most, 1);
  const std::string& id = basins[static_cast<std::size_t>(most - outside.begin())].id;
  const std::string beyond = " beyond the hull of the gauges, where the nearest gauge counts";
  const std::string text = count == 1
                               ? share + " % of basin " + quoted(id, 80) + " lies" + beyond
                               : "parts of " + std::to_string(count) + " basins lie" + beyond +
                                     "; of basin " + quoted(id, 80) + " most, " + share + " %";
  warnings.add({"", 0, "natural neighbours: " + text, ""});
}

std::unique_ptr<const AreaMethod> natural_neighbours(const Weighing& weighing, std::size_t points,
                                                     unsigned threads, Warnings& warnings) {
  auto method = std::make_unique<const NaturalNeighbours>(weighing, points, threads);
  warn_of_hull(method->shares_outside(), weighing.basins(), warnings);
  return method;
}

/// By each of the single methods, in their order.
std::unique_ptr<const StepRainfall> by_all(
    const std::function<std::unique_ptr<const StepRainfall>(RainMethod)>& rainfall) {
  std::vector<std::unique_ptr<const StepRainfall>> methods;
  methods.reserve(single_methods.size());
  for (const RainMethod method : single_methods) methods.push_back(rainfall(method));
  return std::make_unique<const SeveralMethods>(std::move(methods));
}

}  // namespace

// The switches have no default, so that the compiler tells of a method that is forgotten in one.

std::string name_of(RainMethod method) {
  switch (method) {
    case RainMethod::thiessen:
      return ArealRainfall::name;
    case RainMethod::arithmetic:
      return ArithmeticMean::name;
    case RainMethod::idw:
      return InverseDistance::name;
    case RainMethod::natural:
      return NaturalNeighbours::name;
    case RainMethod::all:
      break;
  }
  throw std::logic_error("several methods have no one name");
}

bool averages_points(RainMethod method) {
  switch (method) {
    case RainMethod::thiessen:
    case RainMethod::arithmetic:
      return false;
    case RainMethod::idw:
    case RainMethod::natural:
    case RainMethod::all:
      return true;
  }
  throw std::logic_error("not a method");
}

std::vector<std::string> names_of_methods(RainMethod method) {
  std::vector<std::string> names;
  if (method != RainMethod::all) return names;
  for (const RainMethod one : single_methods) names.push_back(name_of(one));
  return names;
}

std::unique_ptr<const StepRainfall> rainfall_by(const MethodOptions& options,
                                                const Weighing& weighing,
                                                const ArealRainfallSettings& settings,
                                                unsigned threads, Warnings& warnings) {
  const auto by = [&](std::unique_ptr<const AreaMethod> method) {
    return std::make_unique<const MethodRainfall>(weighing, std::move(method), settings);
  };
  const std::function<std::unique_ptr<const StepRainfall>(RainMethod)> rainfall =
      [&](RainMethod method) -> std::unique_ptr<const StepRainfall> {
    switch (method) {
      case RainMethod::thiessen:
        return std::make_unique<const ArealRainfall>(weighing, settings, threads);
      case RainMethod::arithmetic:
        return by(std::make_unique<const ArithmeticMean>(weighing));
      case RainMethod::idw:
        return by(std::make_unique<const InverseDistance>(weighing, options.points(), threads));
      case RainMethod::natural:
        return by(natural_neighbours(weighing, options.points(), threads, warnings));
      case RainMethod::all:
        return by_all(rainfall);
    }
    throw std::logic_error("not a method");
  };
  return rainfall(options.method());
}

}  // namespace thiessen::cli
