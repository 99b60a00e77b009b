#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/text_lines.h"

namespace thiessen {

/// The clock, in minutes, of a line of SWAT's rain in steps shorter than a day: seven characters of
/// the date, two of the hour, a colon and two of the minute. Nothing where it has none.
std::optional<int> swat_clock(std::string_view line);

/// Whether a line is of a whole day without rain among such steps: there the clock is left blank.
bool is_dry_day_of_swat(std::string_view line);

/// The clocks of the first day that has any, in their order; none where a line is of a day.
/// `lines`: those below the heads of the gauges. Reads up to the end of that day.
std::vector<int> swat_clocks(TextLines& lines);

/// The values behind the clock: five characters a gauge as the documentation has them, or six with
/// two decimals as later versions of the model read them, which the line's length tells. Empty
/// where it is neither.
std::vector<std::string> swat_values_of_step(std::string_view line, std::size_t gauges);

}  // namespace thiessen
