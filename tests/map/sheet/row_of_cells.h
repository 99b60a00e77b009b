#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "map/sheet/picture.h"

namespace thiessen {

/// No reading.
constexpr double none = std::numeric_limits<double>::quiet_NaN();

inline MultiPolygon square(double x, double y, double side) {
  return {{{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {}}};
}

/// Square cells side by side, gauges in their middles, each with the rainfall given.
inline Picture row_of_cells(const std::vector<double>& rainfall) {
  Picture picture;
  picture.by_rainfall = true;
  picture.title = "Row";
  picture.units = "mm";
  picture.width = 480;
  for (std::size_t i = 0; i < rainfall.size(); ++i) {
    const double x = static_cast<double>(i);
    picture.cells.push_back({square(x, 0, 1), i, rainfall[i]});
    picture.gauges.push_back({{x + 0.5, 0.5}, "G" + std::to_string(i), std::isfinite(rainfall[i])});
  }
  const double length = static_cast<double>(rainfall.size());
  picture.basins.push_back({"B", {{{{0, 0}, {length, 0}, {length, 1}, {0, 1}}, {}}}});
  return picture;
}

}  // namespace thiessen
