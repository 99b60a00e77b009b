#include "cli/rain_methods.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "rainfall/methods/arithmetic_mean.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/method_rainfall.h"
#include "rainfall/methods/natural_neighbours.h"

namespace thiessen::cli {
namespace {

constexpr std::array all_methods{
    std::pair(RainMethod::thiessen, "thiessen"), std::pair(RainMethod::arithmetic, "arithmetic"),
    std::pair(RainMethod::idw, "idw"), std::pair(RainMethod::natural, "natural")};

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

}  // namespace

std::vector<std::string> names_of_methods(RainMethod method) {
  std::vector<std::string> names;
  if (method != RainMethod::all) return names;
  for (const auto& [one, name] : all_methods) names.emplace_back(name);
  return names;
}

std::unique_ptr<const StepRainfall> rainfall_by(const MethodOptions& options,
                                                const Weighing& weighing,
                                                const ArealRainfallSettings& settings,
                                                unsigned threads, Warnings& warnings) {
  const auto by = [&](std::unique_ptr<const AreaMethod> method) {
    return std::make_unique<const MethodRainfall>(weighing, std::move(method), settings);
  };
  const auto rainfall = [&](RainMethod method) -> std::unique_ptr<const StepRainfall> {
    switch (method) {
      case RainMethod::arithmetic:
        return by(std::make_unique<const ArithmeticMean>(weighing));
      case RainMethod::idw:
        return by(std::make_unique<const InverseDistance>(weighing, options.points(), threads));
      case RainMethod::natural:
        return by(natural_neighbours(weighing, options.points(), threads, warnings));
      default:
        return std::make_unique<const ArealRainfall>(weighing, settings, threads);
    }
  };
  if (options.method() != RainMethod::all) return rainfall(options.method());
  std::vector<std::unique_ptr<const StepRainfall>> methods;
  methods.reserve(all_methods.size());
  for (const auto& [method, name] : all_methods) methods.push_back(rainfall(method));
  return std::make_unique<const SeveralMethods>(std::move(methods));
}

}  // namespace thiessen::cli
