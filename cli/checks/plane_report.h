#pragma once

#include <string>

#include "cli/inputs/inputs.h"

namespace thiessen::cli {

/// Says which plane the study has and what it does to weights and areas; empty for a geodesic study
/// and a plane without a CRS.
std::string describe_plane(const Inputs& inputs);

}  // namespace thiessen::cli
