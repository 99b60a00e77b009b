#pragma once

#include <cstddef>

#include "rainfall/gaps/handover.h"
#include "rainfall/series/step_sample.h"

namespace thiessen {

/// What a run computes, and what a search for its most influential gauges would add, in
/// microseconds of one thread on the machine that the figures were measured on. They are counted,
/// not timed, so that what is looked at, and so every byte that is written, is the same on every
/// machine and in every run. Right to a factor of two.
struct SearchWork {
  double run = 0;   ///< tessellation, weights, readings, values and pictures of the whole series
  double once = 0;  ///< of the search: however few steps it looks at
  double all = 0;   ///< of the search: what all steps of the sample add to that
  std::size_t steps = 0;  ///< number of steps in the sample
};

/// Counts the work of a run over a series of `steps_of_series` steps, of which `sample` is a
/// sample. Every handover counts once, as it is remembered. Cost: for each set of reporting gauges
/// in the sample, the cells and their neighbours.
SearchWork search_work(const Handovers& handovers, const StepSample& sample,
                       std::size_t steps_of_series);

/// How many steps of the sample to go on at a time, so that the search adds no more than `share` to
/// the run, or no more than `least` microseconds, or only one step is looked at.
std::size_t spacing_within(const SearchWork& work, double share, double least = 0);

}  // namespace thiessen
