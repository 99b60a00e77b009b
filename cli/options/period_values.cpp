#include "cli/options/period_values.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "cli/options/option_values.h"

namespace thiessen::cli {
namespace {

/// A year of 366 days.
constexpr std::size_t most_hours = 8'784;

[[noreturn]] void refuse(const std::string& wanted, const std::string& text) {
  throw WrongValue{"wants " + wanted + ", not '" + printable(text) + "'"};
}

std::optional<int> two_digits(std::string_view text) {
  const auto number = parse_size(text);
  if (text.size() != 2 || !number) return std::nullopt;
  return static_cast<int>(number.value);
}

}  // namespace

std::optional<std::int64_t> duration_in(std::string_view text) {
  constexpr std::int64_t most = std::int64_t{8'784} * 3'600;  // a year of 366 days
  constexpr std::array<std::pair<std::string_view, std::int64_t>, 3> units{
      {{"min", 60}, {"h", 3'600}, {"d", 86'400}}};
  for (const auto& [unit, seconds] : units) {
    if (!text.ends_with(unit)) continue;
    const auto number = parse_size(text.substr(0, text.size() - unit.size()));
    if (!number || number.value == 0 || number.value > static_cast<std::size_t>(most / seconds))
      return std::nullopt;
    return static_cast<std::int64_t>(number.value) * seconds;
  }
  return std::nullopt;
}

OptionValue periods(std::optional<Every>& target) {
  const std::vector<std::pair<std::string, PeriodUnit>> units{
      {"hour", PeriodUnit::hours},  {"day", PeriodUnit::day},       {"week", PeriodUnit::week},
      {"month", PeriodUnit::month}, {"season", PeriodUnit::season}, {"year", PeriodUnit::year},
      {"storm", PeriodUnit::storm}};
  OptionValue value;
  value.kind = "hour|Nh|day|week|month|season|year|storm";
  for (const auto& [name, unit] : units) value.choices.push_back(name);
  value.read = [&target, units](const std::string& text) {
    for (const auto& [name, unit] : units) {
      if (name == text) return static_cast<void>(target = unit);
    }
    const auto hours =
        parse_size(std::string_view(text).substr(0, text.empty() ? 0 : text.size() - 1));
    if (!text.ends_with('h') || !hours || hours.value == 0 || hours.value > most_hours) {
      refuse("hour, Nh (such as 6h, to 8784h), day, week, month, season, year or storm", text);
    }
    target = PeriodUnit::hours;
    target->hours = static_cast<int>(hours.value);
  };
  return value;
}

OptionValue time_of_day(std::int64_t& target) {
  OptionValue value;
  value.kind = "HH:MM";
  value.read = [&target](const std::string& text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const auto hour = two_digits(std::string_view(text).substr(0, colon));
    const auto minute = two_digits(std::string_view(text).substr(std::min(colon + 1, text.size())));
    if (!hour || !minute || *hour > 23 || *minute > 59)
      refuse("a time of day from 00:00 to 23:59, such as 09:00", text);
    target = std::int64_t{3'600} * *hour + std::int64_t{60} * *minute;
  };
  return value;
}

OptionValue duration(std::int64_t& target) {
  OptionValue value;
  value.kind = "TIME";
  value.read = [&target](const std::string& text) {
    const auto seconds = duration_in(text);
    if (!seconds) refuse("a length of time such as 6h, 90min or 2d", text);
    target = *seconds;
  };
  return value;
}

OptionValue durations(std::vector<NamedDuration>& target) {
  OptionValue value;
  value.kind = "TIME,...";
  value.read = [&target](const std::string& text) {
    std::vector<NamedDuration> read;
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t comma = std::min(text.find(',', at), text.size());
      const std::string name = text.substr(at, comma - at);
      const auto seconds = duration_in(name);
      if (!seconds) refuse("lengths of time such as 1h,24h or 15min", text);
      for (const NamedDuration& other : read) {
        if (other.seconds == *seconds) throw WrongValue{"names " + printable(name) + " twice"};
      }
      read.push_back({name, *seconds});
      at = comma + 1;
    }
    target = std::move(read);
  };
  return value;
}

}  // namespace thiessen::cli
