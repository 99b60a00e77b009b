#pragma once

#include <cstddef>
#include <string>

#include "cli/inputs/inputs.h"
#include "rainfall/series/step_intervals.h"
#include "study/weight_findings.h"

namespace thiessen::cli {

/// Says how many stations and places there are, which CRS and metric, and what a plane does; lines.
std::string describe_study(const Inputs& inputs);

/// Says how many basins are without a gauge and how many gauges weigh in none; lines.
std::string describe_weights(const WeightFindings& findings);

/// The steps of RAINFALL, as far as they have passed.
struct PassedSteps {
  std::size_t steps = 0;
  std::size_t missing = 0;  ///< readings of the network's gauges
  StepIntervals intervals = {};
  std::string unit = {};  ///< of the readings, where it is known
};

/// Says how many steps there are, what is missing, whether readings are rates, and which steps a
/// regular series lacks; lines.
std::string describe_steps(const Inputs& inputs, const PassedSteps& passed);

}  // namespace thiessen::cli
