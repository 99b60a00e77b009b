#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// Round coordinates along an axis.
struct AxisTicks {
  struct Tick {
    double at = 0;     ///< less the axis' origin
    std::string text;  ///< of the coordinate less `base`
  };
  std::vector<Tick> ticks;
  std::string base;  ///< empty for 0

  /// The axis' name, less its base: "x", or "x - 4000000".
  std::string title(char name) const;
};

/// The round coordinates from origin + low to origin + high, `most` of them or a few less. Where
/// they would differ in their sixth digit or later alone, they are counted from a base.
/// Requires finite coordinates, low < high.
AxisTicks axis_ticks(double origin, double low, double high, int most);

}  // namespace thiessen
