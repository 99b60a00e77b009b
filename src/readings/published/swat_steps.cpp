#include "readings/published/swat_steps.h"

#include <algorithm>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t date_width = 7;
constexpr std::size_t clock_width = 5;
constexpr std::size_t label_width = date_width + clock_width;

/// A number of one or two digits, with or without a blank before it, below a limit.
std::optional<int> part_below(int limit, std::string_view text) {
  text = trimmed(text);
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos)
    return std::nullopt;
  int number = 0;
  for (const char digit : text) number = 10 * number + (digit - '0');
  return number < limit ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<int> swat_clock(std::string_view line) {
  constexpr int hours = 24;
  constexpr int minutes = 60;
  if (line.size() <= label_width || line[date_width + 2] != ':') return std::nullopt;
  const auto hour = part_below(hours, line.substr(date_width, 2));
  const auto minute = part_below(minutes, line.substr(date_width + 3, 2));
  return hour && minute ? std::optional(minutes * *hour + *minute) : std::nullopt;
}

bool is_dry_day_of_swat(std::string_view line) {
  return line.size() > label_width && trimmed(line.substr(date_width, clock_width)).empty();
}

std::vector<int> swat_clocks(TextLines& lines) {
  std::vector<int> clocks;
  std::string day;
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty() || (clocks.empty() && is_dry_day_of_swat(*line))) continue;
    const auto clock = swat_clock(*line);
    if (!clock || (!clocks.empty() && line->substr(0, date_width) != day)) break;
    day = line->substr(0, date_width);
    clocks.push_back(*clock);
  }
  return clocks;
}

std::vector<std::string> swat_values_of_step(std::string_view line, std::size_t gauges) {
  const std::size_t end = line.find_last_not_of(" \t") + 1;
  std::vector<std::string> values;
  for (const std::size_t width : {std::size_t{5}, std::size_t{6}}) {
    if (gauges == 0 || end != label_width + gauges * width) continue;
    for (std::size_t i = 0; i < gauges; ++i)
      values.emplace_back(trimmed(line.substr(label_width + i * width, width)));
  }
  return values;
}

}  // namespace thiessen
