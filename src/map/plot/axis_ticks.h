#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// Round coordinates to be written along an axis.
struct AxisTicks {
  struct Tick {
    double at = 0;     ///< coordinate less the axis' origin
    std::string text;  ///< text of the coordinate less `base`
  };
  std::vector<Tick> ticks;
  std::string base;  ///< text of a number that all ticks leave out; empty for 0

  /// The axis' name, less the base where there is one: "x", or "x - 4000000".
  std::string title(char name) const;
};

/// The round coordinates from origin + low to origin + high: `most` of them or a few less. Where
/// they would differ only in their sixth digit or later, they are counted from a base. Requires
/// finite coordinates, low < high.
AxisTicks axis_ticks(double origin, double low, double high, int most);

}  // namespace thiessen
