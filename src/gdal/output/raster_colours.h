#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace thiessen {

/// A colour as a raster attribute table holds it.
struct RasterColour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

/// Gives the colours of all stations in the order of their numbers. It is asked once, when all
/// pixels have been given.
using StationColours = std::function<std::vector<RasterColour>()>;

/// The values from `low` to `high`, both included, which have one colour.
struct RasterClass {
  double low = 0;
  double high = 0;
  RasterColour colour;
};

}  // namespace thiessen
