#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "map/ink/canvas.h"

namespace thiessen {

/// An entry of a raster's legend.
struct StyleEntry {
  double value = 0;  ///< a pixel's value, or the largest one of a class
  std::string label;
  Colour colour;
};

/// A style that QGIS finds beside a raster, as `map.qml` beside `map.tif`: each value has its own
/// colour. Its first band is meant.
std::string style_of_values(std::span<const StyleEntry> entries);

/// The same where entries are classes, from the lowest to the highest. A value belongs to the first
/// class that reaches up to it; the last one has no end.
std::string style_of_classes(std::span<const StyleEntry> entries);

/// The same where the numbers from 1 to `last` have colours that run from one of our soft colours
/// to the next, over and over, in `step` numbers each. It has no entry for each number, so that
/// QGIS opens it at once, but numbers far from each other may have one colour. Requires a number,
/// and a step of at least 1.
std::string style_of_numbers(std::size_t last, std::size_t step);

}  // namespace thiessen
