#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/network/step_rainfall.h"

namespace thiessen {

/// What areal rainfall is computed by.
enum class RainMethod { thiessen, arithmetic, idw, natural };

/// All methods, in the order of their columns.
inline constexpr std::array all_methods{RainMethod::thiessen, RainMethod::arithmetic,
                                        RainMethod::idw, RainMethod::natural};

/// The name that the method's class gives itself.
const char* name_of(RainMethod method);

/// Whether the method is a mean over points of a basin.
bool averages_points(RainMethod method);

/// The names of the methods where each basin has a value by several of them, in their order; else
/// none.
std::vector<std::string> names_of_methods(const std::vector<RainMethod>& methods);

/// Gets ready to compute by one method, or by several in the order of their columns. `points`: how
/// many in a basin a method takes its mean over, where it does. Warns of basins that reach beyond
/// the gauges' hull, where natural neighbours are wanted. The weighing must outlive it.
std::unique_ptr<const StepRainfall> rainfall_by(const std::vector<RainMethod>& methods,
                                                const Weighing& weighing, std::size_t points,
                                                const ArealRainfallSettings& settings,
                                                unsigned threads, Warnings& warnings);

}  // namespace thiessen
