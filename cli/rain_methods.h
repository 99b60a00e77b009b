#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/options.h"
#include "rainfall/step_rainfall.h"

namespace thiessen::cli {

/// The methods that are one, in the order of their columns.
inline constexpr std::array single_methods{RainMethod::thiessen, RainMethod::arithmetic,
                                           RainMethod::idw, RainMethod::natural};

/// The name that the method's class gives itself. Requires a method other than all.
std::string name_of(RainMethod method);

/// Whether the method, or one of all, is a mean over points of a basin.
bool averages_points(RainMethod method);

/// The names of the methods where each basin has a value by several of them, in their order; else
/// none.
std::vector<std::string> names_of_methods(RainMethod method);

/// Gets ready to compute by a method, or by all. Warns of basins that reach beyond the gauges'
/// hull, where natural neighbours are wanted. The weighing must outlive it.
std::unique_ptr<const StepRainfall> rainfall_by(const MethodOptions& options,
                                                const Weighing& weighing,
                                                const ArealRainfallSettings& settings,
                                                unsigned threads, Warnings& warnings);

}  // namespace thiessen::cli
