#pragma once

#include <string>

#include "cli/inputs/inputs.h"
#include "results/provenance.h"

namespace thiessen::cli {

/// What an output of these inputs says of how it was made. `unit` is that of the rainfall, empty
/// where there is none.
Provenance provenance_of(const Inputs& inputs, const StudyOptions& options,
                         const std::string& unit);

}  // namespace thiessen::cli
