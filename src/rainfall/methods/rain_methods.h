#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/network/step_rainfall.h"
#include "rainfall/weighed_rainfall.h"

namespace thiessen {

/// What areal rainfall is computed by.
enum class RainMethod { thiessen, arithmetic, idw, natural, isohyetal };

/// The methods that weigh gauges, in the order of their columns: what users mean by all. Isohyets
/// come beside them where they are asked for.
inline constexpr std::array all_methods{RainMethod::thiessen, RainMethod::arithmetic,
                                        RainMethod::idw, RainMethod::natural};

/// The name that the method's class gives itself.
const char* name_of(RainMethod method);

/// Whether the method is a mean over points of a basin.
bool averages_points(RainMethod method);

/// The names of the methods where each basin has a value by several of them, in their order; else
/// none.
std::vector<std::string> names_of_methods(const std::vector<RainMethod>& methods);

/// How methods that look at points of a basin do it.
struct PointSettings {
  std::size_t points = 2000;  ///< how many in a basin
  double interval = 0;        ///< between isohyets; 0: a rounded step
};

/// Makes of the rainfall by a method that weighs gauges, for a month's normals or the year's, what
/// says more of it, such as its errors.
using AroundRainfall = std::function<std::unique_ptr<const StepRainfall>(
    std::unique_ptr<const WeighedRainfall> rainfall, const NormalMonth& month)>;

/// Gets ready to compute by one method, or by several in the order of their columns. Warns of
/// basins that reach beyond the gauges' hull, where natural neighbours are wanted. The weighing
/// must outlive it. What weighs gauges is handed to `around`, where there is one.
std::unique_ptr<const StepRainfall> rainfall_by(const std::vector<RainMethod>& methods,
                                                const Weighing& weighing,
                                                const PointSettings& points,
                                                const ArealRainfallSettings& settings,
                                                unsigned threads, Warnings& warnings,
                                                const AroundRainfall& around = {});

}  // namespace thiessen
