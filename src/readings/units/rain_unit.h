#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "rainfall/series/step_length.h"

namespace thiessen {

/// A unit in which rain is written: a depth of water, or a depth within a time. In millimetres it
/// is `multiply / divide`, two whole numbers, so that a conversion costs no digits.
struct RainUnit {
  std::string_view depth;  ///< mm, cm, m, in, ft, 0.1mm or 0.01in
  std::string_view rate;   ///< what follows the depth where it falls in a time: /h, /15min, /day
  std::int64_t multiply = 1;
  std::int64_t divide = 1;

  std::string name() const { return std::string(depth) + std::string(rate); }
};

/// A factor as a quotient of whole numbers or of the user's number and 1: tenths of a millimetre
/// divided by ten are as near as a double can be, which those times 0.1 are not.
struct RainFactor {
  double multiply = 1;
  double divide = 1;

  double of(double amount) const { return amount * multiply / divide; }
  bool is_one() const { return multiply == divide; }
};

/// The unit that a text names, case and blanks within it ignored: `mm`, `inches`, `0.1 mm`,
/// `tenths of mm`, `l/m2`; a rate `mm/h`, `mm h-1`, `inches per day`, `mm/15 min`, `kg m-2 s-1`.
/// Nothing where it names none.
std::optional<RainUnit> rain_unit(std::string_view text);

/// The time in which the depth of a unit falls; nothing where the unit is a depth alone.
std::optional<StepLength> time_of_rate(const RainUnit& unit);

/// What the depth of values in a unit is in, summed over a time: of mm/h mm. Of what names no unit
/// of rain it is the same text.
std::string depth_unit(const std::string& unit);

/// The unit that ends a column's name after what stands before it: `_mm`, ` (mm)`, `[in]`.
std::optional<RainUnit> unit_in_suffix(std::string_view suffix);

/// The unit in a column's name: in brackets at its end (`total [cm]`), or after a known name of
/// values (`prcp_in`), or one that is nothing else than a unit of rain (`catch_mm`).
std::optional<RainUnit> unit_in_name(std::string_view column);

/// The unit that a line above a header says: after a label (`Units: inches`, `# unit = mm`), or at
/// the end of a title of rain (`Daily rainfall in inches`, `Precipitation [mm]`). Nothing where it
/// says none; metres and feet count nowhere, for they may be those of a height.
std::optional<RainUnit> unit_in_line(std::string_view line);

/// Whether a text speaks of rain: a title, or the name of what is measured (PRCP, Niederschlag).
bool speaks_of_rain(std::string_view text);

/// What takes an amount from one unit to another. Requires two of one rate, or two rates by the
/// clock; where one of them is a depth alone, the other's depth counts.
RainFactor factor_between(const RainUnit& from, const RainUnit& to);

}  // namespace thiessen
