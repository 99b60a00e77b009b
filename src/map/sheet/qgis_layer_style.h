#pragma once

#include <span>
#include <string>
#include <vector>

#include "map/sheet/rainfall_classes.h"

namespace thiessen {

/// A class of a layer's features, as QGIS draws it.
struct StyledClass {
  std::string filter;  ///< which features it is of, in QGIS's expressions
  std::string label;
  Colour colour;
};

/// The classes as a layer with a field `rainfall` has them: 0 by itself where it is dry, each other
/// class from its lower bound up to, and without, its upper one. `unit` follows the numbers; it may
/// be empty.
std::vector<StyledClass> styled_classes(const RainfallClasses& classes, const std::string& unit);

/// Styles for QGIS of a layer of vectors, in its XML: for the polygons of cells, filled by class
/// or, where there is none, in one pale colour; for the outlines of basins with their names; for
/// gauges as dots with their names, hollow where a field `rainfall` has none; for isohyets with
/// their values.
std::string style_of_cells(std::span<const StyledClass> classes);
std::string style_of_basins();
std::string style_of_gauges(bool has_rainfall);
std::string style_of_isohyets();

}  // namespace thiessen
