#pragma once

#include <functional>
#include <vector>

#include "base/colour.h"

namespace thiessen {

/// Gives the colours of all stations in the order of their numbers. It is asked once, when all
/// pixels have been given.
using StationColours = std::function<std::vector<Colour>()>;

/// The values from `low` to `high`, both included, which have one colour.
struct RasterClass {
  double low = 0;
  double high = 0;
  Colour colour;
};

}  // namespace thiessen
