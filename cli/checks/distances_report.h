#pragma once

#include <string>

#include "cli/inputs/inputs.h"

namespace thiessen::cli {

/// Names gauges at 0, 0 and gauges far from all others, in a line each; empty where there are none.
std::string odd_gauges_text(const Inputs& inputs);

/// A table of the basins with the nearest gauge of each, the farthest first.
std::string nearest_gauges_table(const Inputs& inputs);

}  // namespace thiessen::cli
