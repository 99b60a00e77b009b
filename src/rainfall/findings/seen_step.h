#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "rainfall/network/network.h"

namespace thiessen {

/// A step as it is looked at for single readings that cannot be true.
struct SeenStep {
  const std::string& time;
  std::span<const double> readings;      ///< one for each station; NaN where it is silent
  std::span<const StationIndex> wet;     ///< those that read more than 0, in their order
  std::span<const StationIndex> silent;  ///< those without a reading
  bool follows;  ///< whether it is the step after the one before it, with none between
};

}  // namespace thiessen
