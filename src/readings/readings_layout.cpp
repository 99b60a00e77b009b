#include "readings/readings_layout.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/enumeration.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"
#include "readings/first_row.h"
#include "readings/times/time_parts.h"
#include "readings/times/time_shape.h"
#include "readings/units/rain_unit.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::size_t names_told = 7;

bool means(std::string_view header, std::string_view name, bool with_unit) {
  header = trimmed(header);
  if (same_name(header, name)) return true;
  return with_unit && header.size() > name.size() &&
         same_name(header.substr(0, name.size()), name) &&
         unit_in_suffix(header.substr(name.size())).has_value();
}

/// The columns that stand in the file.
std::string list(const Table& table) {
  return names_up_to(10, std::span(table.header()).first(table.columns_in_file()), 60);
}

class LayoutFinder {
 public:
  LayoutFinder(const Table& table, const ReadingsStations& stations)
      : table_(table), stations_(stations) {}

  /// Finds the column that the user names. A column of exactly this name comes before one that
  /// differs in case.
  std::size_t column_named(const std::string& name, const Wording& its_setting) const {
    const std::optional<std::size_t> found = find_named(name);
    if (!found) fail("there is no column " + quoted(name), "see " + its_setting);
    return *found;
  }

  std::optional<std::size_t> column_among(Names names, bool with_unit) const {
    const auto& header = table_.header();
    for (const std::string_view name : names) {
      for (std::size_t i = 0; i < header.size(); ++i) {
        if (means(header[i], name, with_unit)) return i;
      }
    }
    return std::nullopt;
  }

  std::size_t column(const std::string& given, const Wording& its_setting, Names names,
                     bool with_unit) const {
    if (!given.empty()) return column_named(given, its_setting);
    const std::optional<std::size_t> found = column_among(names, with_unit);
    if (!found) fail_without(names, its_setting + " names it");
    return *found;
  }

  /// The same, and a number that no column has where there is none.
  std::size_t column_or_none(const std::string& given, Names names, bool with_unit) const {
    const auto found = given.empty() ? column_among(names, with_unit) : find_named(given);
    return found.value_or(table_.header().size());
  }

  [[noreturn]] void fail_without(Names names, const Wording& hint) const {
    fail("no column is called " + listed(names.first(std::min(names_told, names.size()))) +
             " or the like",
         hint);
  }

  bool is_station(std::size_t column) const {
    return stations_.find(table_.header()[column]).standing != ReadingsStations::Standing::unknown;
  }

  [[noreturn]] void fail(const std::string& text, const Wording& hint) const {
    throw Error(
        {table_.file(), table_.header_line(), text + "; the columns are " + list(table_), hint});
  }

 private:
  std::optional<std::size_t> find_named(const std::string& name) const {
    const auto& header = table_.header();
    auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) {
      found = std::find_if(header.begin(), header.end(), [&](const std::string& other) {
        return equal_ignoring_case(trimmed(other), trimmed(name));
      });
    }
    if (found == header.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header.begin());
  }

  const Table& table_;
  const ReadingsStations& stations_;
};

bool looks_long(const LayoutFinder& finder) {
  const auto station = finder.column_among(known::station_ids, false);
  const auto value = finder.column_among(known::values, true);
  return station && value && !finder.is_station(*station) && !finder.is_station(*value);
}

/// The columns of the time that the user names. Where a format is given, it is of their texts as
/// they stand.
std::optional<TimeColumns> named_time(const LayoutFinder& finder, const ReadingsOptions& options) {
  std::vector<TimeColumns::Column> columns;
  for (const std::string& name : options.time_fields) {
    const bool has_parts = options.time_fields.size() > 1 && options.time_format.empty();
    columns.push_back({finder.column_named(name, setting("time_field")),
                       has_parts ? TimeColumns::part_called(name) : TimeColumns::Part::text});
  }
  if (columns.empty()) return std::nullopt;
  return TimeColumns(std::move(columns));
}

/// The columns among which those of a time are, but for those that hold something else.
TimeCandidates candidates_in(const LayoutFinder& finder, const Table& table,
                             std::vector<std::size_t> others) {
  return {table.header(), [&table] { return first_row(table); },
          [&finder, others = std::move(others)](std::size_t column) {
            return std::ranges::find(others, column) == others.end() && !finder.is_station(column);
          }};
}

/// A column of dates and one of clocks, if the table has both and no column that holds a whole
/// time; the column of dates alone where these have a clock of their own.
std::optional<TimeColumns> date_and_clock(const LayoutFinder& finder, const Table& table) {
  const auto date = finder.column_among(known::dates, false);
  const auto clock = finder.column_among(known::clocks, false);
  if (!date || !clock || *date == *clock || finder.is_station(*clock)) return std::nullopt;
  const auto& header = table.header();
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (i != *date && i != *clock && find_field({header[i]}, known::times)) return std::nullopt;
  }
  const std::vector<std::string> row = first_row(table);
  const TimeColumns::Part part = TimeColumns::part_called(header[*clock]);
  const bool is_number =
      part == TimeColumns::Part::hour_minute && !row.empty() && parse_size(trimmed(row[*clock]));
  if (row.empty() || !(is_number || is_clock(row[*clock]))) return std::nullopt;
  if (is_date_with_clock(row[*date])) return TimeColumns(*date);
  if (!is_date(row[*date])) return std::nullopt;
  const bool is_part = part == TimeColumns::Part::hour || part == TimeColumns::Part::hour_minute;
  return TimeColumns(
      {{*date, TimeColumns::Part::text}, {*clock, is_part ? part : TimeColumns::Part::text}});
}

/// A column that is called time or the like, and not for the day or the hour alone.
std::optional<std::size_t> whole_time(const LayoutFinder& finder, const Table& table) {
  const auto found = finder.column_among(known::times, false);
  if (!found || TimeColumns::part_called(table.header()[*found]) != TimeColumns::Part::text)
    return std::nullopt;
  return found;
}

/// Whether a text is a date with a clock, in ISO 8601 or any form that is known.
bool is_whole_time(std::string_view text) {
  const ParsedTime time = parse_iso_time(trimmed(text));
  return is_date_with_clock(text) || (time && time.time.precision == TimePrecision::instant);
}

bool holds_whole_times(const Table& table, std::size_t column) {
  const std::vector<std::string> row = first_row(table);
  return column < row.size() && is_whole_time(row[column]);
}

/// The same of a long table: of columns of such names one whose first text is a date with a clock,
/// before one that holds a date or a clock alone.
std::optional<std::size_t> wholest_time(const LayoutFinder& finder, const Table& table) {
  const auto found = whole_time(finder, table);
  const auto& header = table.header();
  const auto is_called_time = [&](std::size_t i) {
    return find_field({header[i]}, known::times) &&
           TimeColumns::part_called(header[i]) == TimeColumns::Part::text;
  };
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; found && i < header.size(); ++i) {
    if (is_called_time(i)) columns.push_back(i);
  }
  if (columns.size() < 2) return found;
  const std::vector<std::string> row = first_row(table);
  const auto is_whole = [&](std::size_t i) { return is_whole_time(row[i]); };
  if (row.empty() || is_whole(*found)) return found;
  const auto whole = std::ranges::find_if(columns, is_whole);
  return whole == columns.end() ? found : *whole;
}

void find_time_of_wide(const LayoutFinder& finder, const Table& table,
                       const ReadingsOptions& options, ReadingsLayout& layout) {
  if (const auto named = named_time(finder, options)) {
    layout.time = *named;
    return;
  }
  const auto whole = whole_time(finder, table);
  if (const auto pair = date_and_clock(finder, table); pair && pair->has(0)) {
    layout.time = *pair;
    return;
  }
  const TimeCandidates candidates = candidates_in(finder, table, {});
  const auto parts = time_in_parts(candidates);
  const bool has_index = !table.header().empty() && trimmed(table.header()[0]).empty();
  if (whole && !(parts && parts->has(*whole)) && (*whole == 0 || has_index)) {
    layout.time = *whole;
    if (*whole != 0) layout.index = 0;
  } else if (parts && (parts->has(0) || has_index)) {
    layout.time = *parts;
    if (!parts->has(0)) layout.index = 0;
  }
  if (layout.time.columns().size() == 1)
    layout.time_meant = time_fields_meant(candidates, layout.time.columns().front().field);
}

/// A column of years, each a time of its own.
std::optional<std::size_t> years_alone(const LayoutFinder& finder, const TimeCandidates& table) {
  const auto found = finder.column_among(known::years, false);
  if (!found || !table.may_be_of_time(*found)) return std::nullopt;
  const std::vector<std::string> row = table.first_row();
  if (row.empty()) return std::nullopt;
  const ParsedTime time = parse_iso_time(trimmed(row[*found]));
  if (!time || time.time.precision != TimePrecision::year) return std::nullopt;
  return time_fields_meant(table, std::nullopt).empty() ? found : std::nullopt;
}

TimeColumns time_of_long(const LayoutFinder& finder, const Table& table,
                         const ReadingsOptions& options) {
  if (const auto named = named_time(finder, options)) return *named;
  if (const auto pair = date_and_clock(finder, table)) return *pair;
  const auto whole = wholest_time(finder, table);
  const TimeCandidates candidates =
      candidates_in(finder, table,
                    {finder.column_or_none(options.station_field, known::station_ids, false),
                     finder.column_or_none(options.value_field, known::values, true)});
  const auto parts = time_in_parts(candidates);
  if (whole && !(parts && parts->has(*whole))) {
    const Wording meant = time_fields_meant(candidates, *whole);
    if (!meant.empty() && !holds_whole_times(table, *whole))
      throw time_in_more_columns(table, *whole, meant);
    return *whole;
  }
  if (parts) return *parts;
  if (const auto year = years_alone(finder, candidates)) return *year;
  const Wording hint = time_fields_meant(candidates, std::nullopt);
  finder.fail_without(known::times, hint.empty() ? setting("time_field") + " names it" : hint);
}

}  // namespace

ReadingsLayout find_layout(const Table& table, const ReadingsStations& stations,
                           const ReadingsOptions& options) {
  const LayoutFinder finder(table, stations);
  ReadingsLayout layout;
  layout.is_long =
      !options.station_field.empty() || !options.value_field.empty() || looks_long(finder);
  if (!layout.is_long) {
    find_time_of_wide(finder, table, options, layout);
    return layout;
  }
  layout.time = time_of_long(finder, table, options);
  layout.station =
      finder.column(options.station_field, setting("station_field"), known::station_ids, false);
  layout.value = finder.column(options.value_field, setting("value_field"), known::values, true);
  if (layout.time.has(layout.station) || layout.time.has(layout.value) ||
      layout.station == layout.value) {
    finder.fail("time, station and value are not three columns",
                "see " + setting("time_field") + ", " + setting("station_field") + " and " +
                    setting("value_field"));
  }
  return layout;
}

bool is_called_as_values(std::string_view column) {
  return std::ranges::any_of(known::values,
                             [&](std::string_view name) { return means(column, name, true); });
}

bool is_long_header(const std::vector<std::string>& header) {
  return find_field(header, known::station_ids) &&
         std::ranges::any_of(header, is_called_as_values) &&
         (find_field(header, known::times) || find_field(header, known::dates) ||
          find_field(header, known::years));
}

Error time_in_more_columns(const Table& table, std::size_t column, const Wording& meant) {
  const std::string& name = table.header()[column];
  return Error({table.file(), table.header_line(),
                "its time seems to stand in more columns than " + quoted(name, 60),
                meant + ", " + setting("time_field", name) + " that in this one alone"});
}

std::vector<std::size_t> further_values(const Table& table, const ReadingsLayout& layout) {
  std::vector<std::size_t> further;
  const auto& header = table.header();
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (i == layout.value || i == layout.station || layout.time.has(i)) continue;
    if (is_called_as_values(header[i])) further.push_back(i);
  }
  return further;
}

}  // namespace thiessen
