#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options/option.h"
#include "rainfall/periods/every.h"

namespace thiessen::cli {

/// The value that names the periods of totals: hour, 6h, day, week and so on.
OptionValue periods(std::optional<Every>& target);
/// A time of day, HH:MM, in seconds after midnight.
OptionValue time_of_day(std::int64_t& target);
/// A length of time such as 6h, 90min or 2d, in seconds.
OptionValue duration(std::int64_t& target);

/// A length of time and what it is called: 24h.
struct NamedDuration {
  std::string name;
  std::int64_t seconds;
};
/// Lengths of time with commas between them, each once.
OptionValue durations(std::vector<NamedDuration>& target);

/// The seconds of a length of time; nothing where the text is none.
std::optional<std::int64_t> duration_in(std::string_view text);

}  // namespace thiessen::cli
