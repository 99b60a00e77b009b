#pragma once

#include <optional>
#include <string>

#include "map/sheet/rainfall_classes.h"
#include "report/report.h"

namespace thiessen {

/// The classes of all readings that the page's steps show; none where it has no readings.
std::optional<RainfallClasses> classes_of_steps(const Report& report);

/// The map's legend as lists of HTML: the classes of the means, those of the steps, which are
/// hidden until the script shows a step, and the signs that the map has.
std::string report_legend(const Report& report, const std::optional<RainfallClasses>& of_steps);

}  // namespace thiessen
