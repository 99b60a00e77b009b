#include "readings/readings_layout.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/utf8.h"
#include "readings/rain_unit.h"
#include "readings/times/time_shape.h"
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
  constexpr std::size_t shown = 10;
  std::vector<std::string> header = table.header();
  header.resize(table.columns_in_file());
  std::string all;
  for (std::size_t i = 0; i < std::min(shown, header.size()); ++i) {
    all += (i > 0 ? ", " : "") + quoted(header[i], 60);
  }
  if (header.size() > shown) all += " and " + std::to_string(header.size() - shown) + " more";
  return all;
}

class LayoutFinder {
 public:
  LayoutFinder(const Table& table, const ReadingsStations& stations)
      : table_(table), stations_(stations) {}

  /// Finds the column that the user names. A column of exactly this name comes before one that
  /// differs in case.
  std::size_t column_named(const std::string& name, const Wording& its_setting) const {
    const auto& header = table_.header();
    auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) {
      found = std::find_if(header.begin(), header.end(), [&](const std::string& other) {
        return equal_ignoring_case(trimmed(other), trimmed(name));
      });
    }
    if (found == header.end()) fail("there is no column " + quoted(name), "see " + its_setting);
    return static_cast<std::size_t>(found - header.begin());
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
    if (!found)
      fail("no column is called " + listed(names.first(std::min(names_told, names.size()))) +
               " or the like",
           its_setting + " names it");
    return *found;
  }

  bool is_station(std::size_t column) const {
    return stations_.find(table_.header()[column]).standing != ReadingsStations::Standing::unknown;
  }

  [[noreturn]] void fail(const std::string& text, const Wording& hint) const {
    throw Error(
        {table_.file(), table_.header_line(), text + "; the columns are " + list(table_), hint});
  }

 private:
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

/// The columns of year, month and day, if the table has them, and those of hour and minute.
std::optional<TimeColumns> time_in_parts(const LayoutFinder& finder) {
  using Part = TimeColumns::Part;
  const std::pair<Names, Part> parts[] = {{known::years, Part::year},
                                          {known::months, Part::month},
                                          {known::days, Part::day},
                                          {known::hours, Part::hour},
                                          {known::minutes, Part::minute}};
  std::vector<TimeColumns::Column> columns;
  for (const auto& [names, part] : parts) {
    const auto found = finder.column_among(names, false);
    if (!found && part <= Part::day) return std::nullopt;
    if (!found) break;
    columns.push_back({*found, part});
  }
  return TimeColumns(std::move(columns));
}

/// The first row of a table, as texts of its own; empty where it cannot be seen before it is read.
std::vector<std::string> first_row(const Table& table) {
  try {
    const std::unique_ptr<Table> rows = table.first_rows();
    Row row;
    if (!rows || !rows->next(row)) return {};
    return {row.fields.begin(), row.fields.end()};
  } catch (const Error&) {
    return {};  // the error is met again, and reported, when the rows are read
  }
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
  if (row.empty() || !is_clock(row[*clock])) return std::nullopt;
  if (is_date_with_clock(row[*date])) return TimeColumns(*date);
  if (!is_date(row[*date])) return std::nullopt;
  const bool is_hour = TimeColumns::part_called(header[*clock]) == TimeColumns::Part::hour;
  return TimeColumns({{*date, TimeColumns::Part::text},
                      {*clock, is_hour ? TimeColumns::Part::hour : TimeColumns::Part::text}});
}

/// A column that is called time or the like, and not for the day or the hour alone.
std::optional<std::size_t> whole_time(const LayoutFinder& finder, const Table& table) {
  const auto found = finder.column_among(known::times, false);
  if (!found || TimeColumns::part_called(table.header()[*found]) != TimeColumns::Part::text)
    return std::nullopt;
  return found;
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
  if (whole == std::size_t{0}) return;
  const bool has_index = !table.header().empty() && trimmed(table.header()[0]).empty();
  if (whole && has_index) {
    layout.time = *whole;
    layout.index = 0;
    return;
  }
  const auto parts = time_in_parts(finder);
  if (!parts || !(parts->has(0) || has_index)) return;
  layout.time = *parts;
  if (!parts->has(0)) layout.index = 0;
}

TimeColumns time_of_long(const LayoutFinder& finder, const Table& table,
                         const ReadingsOptions& options) {
  if (const auto named = named_time(finder, options)) return *named;
  if (const auto pair = date_and_clock(finder, table)) return *pair;
  if (const auto whole = whole_time(finder, table)) return *whole;
  if (const auto parts = time_in_parts(finder)) return *parts;
  return finder.column("", setting("time_field"), known::times, false);
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
