#pragma once

#include <optional>
#include <string>

#include "map/sheet/rainfall_classes.h"
#include "report/report.h"

namespace thiessen {

/// What the page's script works with, as JSON that may stand in a `script` element: names, classes
/// of colours, and the series in whole numbers, each times a power of ten that keeps the digits
/// that readings carry and five of areal rainfall. `of_steps` are the classes of the readings, none
/// where there are none.
std::string report_json(const Report& report, const std::optional<RainfallClasses>& of_steps);

/// Says, where it is so, that the series is thinned, and that readings by gauge are left out; empty
/// where all is there. Escaped for HTML.
std::string thinning_text(const Report& report);

}  // namespace thiessen
