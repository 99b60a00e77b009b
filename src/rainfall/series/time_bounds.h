#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/iso_time.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_length.h"

namespace thiessen {

/// When a time step begins and ends, in seconds from the beginning of 1970 by the clock of its file
/// or, where times have a zone, by UTC.
struct TimeBounds {
  double begin;
  double end;
};

/// The bounds of steps whose times tell when they begin, or end. A step is as long as the file's
/// step. Where the file has none, a year, month or day lasts to its end, and a moment until the
/// next later time; the last one is as long as the step before it, and one alone has no length.
/// Where times end their steps it is the other way round. Cost: n log n.
std::vector<TimeBounds> bounds_of(std::span<const IsoTime> times,
                                  const std::optional<StepLength>& step,
                                  Stamp stamp = Stamp::begin);

}  // namespace thiessen
