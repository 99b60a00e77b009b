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

/// Gives the classes of a raster's values, from the lowest on. It is asked once, when all pixels
/// have been given.
using RasterClasses = std::function<std::vector<RasterClass>()>;

}  // namespace thiessen
