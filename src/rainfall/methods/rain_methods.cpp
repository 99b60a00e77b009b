#include "rainfall/methods/rain_methods.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "rainfall/methods/arithmetic_mean.h"
#include "rainfall/methods/inverse_distance.h"
#include "rainfall/methods/isohyetal_rainfall.h"
#include "rainfall/methods/method_rainfall.h"
#include "rainfall/methods/natural_neighbours.h"

namespace thiessen {
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

std::shared_ptr<const AreaMethod> natural_neighbours(const Weighing& weighing, std::size_t points,
                                                     unsigned threads, std::size_t remembered_bytes,
                                                     Warnings& warnings) {
  auto method =
      std::make_shared<const NaturalNeighbours>(weighing, points, threads, remembered_bytes);
  warn_of_hull(method->shares_outside(), weighing.basins(), warnings);
  return method;
}

/// Makes the rainfall by one method for a month's normals, or the year's.
using OfMonth = std::function<std::unique_ptr<const StepRainfall>(const NormalMonth&)>;

/// Makes methods. What a method finds out of the gauges serves all months.
struct MethodMaker {
  const Weighing& weighing;
  const PointSettings& points;
  ArealRainfallSettings settings;
  unsigned threads;
  const AroundRainfall& around;

  std::unique_ptr<const StepRainfall> finished(std::unique_ptr<const WeighedRainfall> rainfall,
                                               const NormalMonth& month) const {
    if (around) return around(std::move(rainfall), month);
    return rainfall;
  }
  OfMonth by(std::shared_ptr<const AreaMethod> method) const {
    return [*this, method = std::move(method)](const NormalMonth& month) {
      return finished(std::make_unique<const MethodRainfall>(weighing, method, settings, month),
                      month);
    };
  }
  OfMonth by_cells() const {
    auto year = std::make_shared<std::unique_ptr<const ArealRainfall>>(
        std::make_unique<const ArealRainfall>(weighing, settings, threads));
    return [*this, year](const NormalMonth& month) {
      return finished(month ? (*year)->of_month(*month) : std::move(*year), month);
    };
  }
  OfMonth by_isohyets(OfMonth natural) const {
    return [*this, natural = std::move(natural)](const NormalMonth& month) {
      return std::make_unique<const IsohyetalRainfall>(weighing, natural(month), points.points,
                                                       points.interval, threads, month);
    };
  }
  // One half of what may be remembered is for the sums of points, one for the weights of steps.
  OfMonth by_natural_neighbours(Warnings& warnings) const {
    ArealRainfallSettings half = settings;
    half.remembered_bytes /= 2;
    const MethodMaker maker{weighing, points, half, threads, around};
    return maker.by(
        natural_neighbours(weighing, points.points, threads, half.remembered_bytes, warnings));
  }
  OfMonth rainfall(RainMethod method, Warnings& warnings) const {
    switch (method) {
      case RainMethod::thiessen:
        return by_cells();
      case RainMethod::arithmetic:
        return by(std::make_shared<const ArithmeticMean>(weighing));
      case RainMethod::idw:
        return by(std::make_shared<const InverseDistance>(weighing, points.points, threads));
      case RainMethod::natural:
        return by_natural_neighbours(warnings);
      case RainMethod::isohyetal:
        return by_isohyets(by_natural_neighbours(warnings));
    }
    throw std::logic_error("not a method");
  }
};

}  // namespace

// The switches have no default, so that the compiler tells of a method that is forgotten in one.

const char* name_of(RainMethod method) {
  switch (method) {
    case RainMethod::thiessen:
      return ArealRainfall::name;
    case RainMethod::arithmetic:
      return ArithmeticMean::name;
    case RainMethod::idw:
      return InverseDistance::name;
    case RainMethod::natural:
      return NaturalNeighbours::name;
    case RainMethod::isohyetal:
      return IsohyetalRainfall::name;
  }
  throw std::logic_error("not a method");
}

bool averages_points(RainMethod method) {
  switch (method) {
    case RainMethod::thiessen:
    case RainMethod::arithmetic:
      return false;
    case RainMethod::idw:
    case RainMethod::natural:
    case RainMethod::isohyetal:
      return true;
  }
  throw std::logic_error("not a method");
}

std::vector<std::string> names_of_methods(const std::vector<RainMethod>& methods) {
  if (methods.size() == 1) return {};
  std::vector<std::string> names;
  names.reserve(methods.size());
  for (const RainMethod method : methods) names.emplace_back(name_of(method));
  return names;
}

std::unique_ptr<const StepRainfall> rainfall_by(const std::vector<RainMethod>& methods,
                                                const Weighing& weighing,
                                                const PointSettings& points,
                                                const ArealRainfallSettings& settings,
                                                unsigned threads, Warnings& warnings,
                                                const AroundRainfall& around) {
  const MethodMaker maker{weighing, points, settings, threads, around};
  std::vector<OfMonth> all;
  all.reserve(methods.size());
  for (const RainMethod method : methods) all.push_back(maker.rainfall(method, warnings));
  const auto in = [&](const NormalMonth& month) -> std::unique_ptr<const StepRainfall> {
    if (all.size() == 1) return all.front()(month);
    std::vector<std::unique_ptr<const StepRainfall>> several;
    several.reserve(all.size());
    for (const OfMonth& rainfall : all) several.push_back(rainfall(month));
    return std::make_unique<const SeveralMethods>(std::move(several));
  };
  const NormalField* const normals = weighing.normals();
  if (normals == nullptr || normals->months() == 1) return in({});
  std::vector<std::unique_ptr<const StepRainfall>> months;
  for (std::size_t m = 0; m < normals->months(); ++m) months.push_back(in(m));
  return std::make_unique<const MonthlyRainfall>(std::move(months), in({}));
}

}  // namespace thiessen
