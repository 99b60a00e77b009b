#include "readings/readings_reader.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/utf8.h"
#include "readings/readings_layout.h"
#include "readings/readings_long.h"
#include "readings/readings_wide.h"
#include "readings/steps/counter_readings.h"
#include "readings/steps/fresh_readings.h"
#include "readings/times/time_columns.h"
#include "readings/times/time_reader.h"
#include "readings/units/converted_readings.h"
#include "readings/units/unit_column.h"
#include "readings/value_columns.h"
#include "text/csv_form.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

/// Has the reader of times see those with which the table begins. What can be read once more can be
/// filtered, too, by the column of times.
void look_at_times(const Table& table, const ReadingsLayout& layout, TimeReader& times) {
  const std::unique_ptr<Table> first = table.first_rows();
  if (!first) return;
  TimeColumns columns = layout.time;
  std::string last;
  std::size_t rows = 0;
  try {
    Row row;
    for (std::size_t bytes = 0; bytes < csv_beginning_bytes && first->next(row);) {
      for (const std::string_view field : row.fields) bytes += field.size() + 1;
      const std::string_view time = columns.text(row);
      // Of a pipe the first row alone can be seen.
      if (++rows == 2 && columns.columns().size() == 1)
        times.times_stand_in(table.header()[columns.columns().front().field]);
      if (time == last) continue;
      times.see(last = time, row.line);
    }
  } catch (const Error&) {
    // The error is met again, and reported, when the rows are read.
  }
}

/// Tells which of day and month comes first where only a later time tells.
void tell_order(const Table& table, const TimeReader& times, Warnings& warnings) {
  const TimeReader::OrderTold told = times.order_told();
  if (told.by.empty()) return;
  const RowPlace place = table.place(told.line);
  warnings.add_notice({table.file(),
                       0,
                       std::string("its dates have the ") + (told.is_day_first ? "day" : "month") +
                           " first, as " + quoted(told.by, 80) + " in line " +
                           std::to_string(place.line) + " tells",
                       {}});
}

std::string columns_told(const Table& table, const ReadingsLayout& layout) {
  std::vector<std::string> names;
  for (const TimeColumns::Column& column : layout.time.columns())
    names.push_back(table.header()[column.field]);
  return "its times stand in the columns " + listed(names);
}

}  // namespace

ReadingGrammar grammar_of(const ReadingsOptions& options, const Table& table) {
  const DecimalMark mark = options.decimal_comma ? DecimalMark::comma : table.decimal_mark();
  return {options.missing, options.trace, mark};
}

namespace {

/// The unit in or below the names of a wide table's stations; empty where the user says one, and
/// they have several. Throws Error where they have several else.
std::string unit_of_stations(const Table& table, const ReadingsStations& stations, bool is_said) {
  std::string unit;
  for (std::size_t i = 0; i < table.header().size(); ++i) {
    const std::string other = table.unit(i);
    if (other.empty() || other == unit) continue;
    if (stations.find(table.header()[i]).standing != ReadingsStations::Standing::known) continue;
    if (!unit.empty() && is_said) return {};
    if (!unit.empty()) {
      throw Error({table.file(), table.header_line() + 1,
                   "its stations read in " + unit + " and in " + other,
                   setting("from_unit") + " says one for all"});
    }
    unit = other;
  }
  return unit;
}

ValueColumn values_of(const Table& table, const ReadingsLayout& layout,
                      const ReadingsStations& stations, const ReadingsOptions& options) {
  ValueColumn column{table.file(), table.header_line(), "", "", table.lines_above()};
  if (layout.is_long) {
    column.name = table.header()[layout.value];
    column.unit = table.unit(layout.value);
  } else {
    column.unit = unit_of_stations(table, stations, options.from_unit.has_value());
  }
  return column;
}

/// Refuses counters of rates: what a counter adds up is a depth.
void require_depths(const AmountConversion& conversion, const std::string& file) {
  const std::optional<RainUnit> unit = rain_unit(conversion.unit);
  if (!unit || !time_of_rate(*unit)) return;
  throw Error({file, 0,
               "the readings are rates in " + conversion.unit + ", and " + setting("cumulative") +
                   " is of counters, which add up depths",
               "leave it out, or " + setting("from_unit", std::string(unit->depth)) +
                   " says that they are depths"});
}

std::unique_ptr<Readings> open_as(const ReadingsLayout& layout, std::unique_ptr<Table> table,
                                  std::unique_ptr<const ReadingsStations> known,
                                  const ReadingsOptions& options, Warnings& warnings) {
  const std::string file = table->file();
  const ReadingsStations& stations = *known;
  const AmountConversion conversion =
      conversion_of(options, values_of(*table, layout, stations, options), warnings);
  if (options.cumulative) require_depths(conversion, file);
  ReadingsFindings findings(file, stations, options.ignore_unknown, warnings);
  findings.amounts_are_in(options.cumulative ? of_a_counter : conversion.millimetres);
  if (options.is_one_of_several || options.is_beside_others) findings.are_of_one_file_of_several();
  if (options.steps_may_differ) findings.steps_may_differ();
  findings.are_of(*table);
  findings.are_in(options.input, options.decimal_comma);
  const ReadingGrammar grammar = grammar_of(options, *table);
  TimeReader times(options.time_format, options.day_first);
  if (layout.time.are_parts()) times.times_are_of_parts();
  look_at_times(*table, layout, times);
  tell_order(*table, times, warnings);
  tell_values(*table, layout, options, warnings);
  if (options.time_fields.empty() && layout.time.columns().size() > 1)
    warnings.add_notice({file, 0, columns_told(*table, layout), {}});
  ReadingsSource source{std::move(table), std::move(known), grammar, std::move(findings),
                        std::move(times)};
  source.stamp = options.stamp;
  source.steps_as_they_come = options.steps_as_they_come;
  source.steps_may_come_again = options.steps_may_come_again;
  std::unique_ptr<Readings> readings;
  if (layout.is_long) {
    readings = std::make_unique<LongReadings>(std::move(source), layout);
  } else {
    readings = std::make_unique<WideReadings>(std::move(source), layout);
  }
  if (options.steps_may_come_again)
    readings = std::make_unique<FreshReadings>(std::move(readings), file, warnings);
  if (options.cumulative && !options.is_one_of_several) {
    readings =
        std::make_unique<CounterReadings>(std::move(readings), file, stations.all(), warnings);
  }
  return converted(std::move(readings), conversion);
}

}  // namespace

std::unique_ptr<Readings> open_readings(std::unique_ptr<Table> table,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings) {
  auto known = std::make_unique<const ReadingsStations>(
      stations, passed_over, IdJoin{options.ids_as_numbers, options.column_of});
  const ReadingsLayout layout = find_layout(*table, *known, options);
  table = with_unit_column(std::move(table), layout, options);
  return open_as(layout, std::move(table), std::move(known), options, warnings);
}

std::unique_ptr<Readings> open_long_readings(std::unique_ptr<Table> table,
                                             const ReadingsLayout& layout,
                                             std::span<const Station> stations,
                                             std::span<const std::string> passed_over,
                                             const ReadingsOptions& options, Warnings& warnings) {
  auto known = std::make_unique<const ReadingsStations>(
      stations, passed_over, IdJoin{options.ids_as_numbers, options.column_of});
  return open_as(layout, std::move(table), std::move(known), options, warnings);
}

}  // namespace thiessen
