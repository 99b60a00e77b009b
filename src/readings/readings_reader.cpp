#include "readings/readings_reader.h"

#include <utility>

#include "readings/converted_readings.h"
#include "readings/readings_layout.h"
#include "readings/readings_long.h"
#include "readings/readings_wide.h"
#include "readings/steps/counter_readings.h"

namespace thiessen {

ReadingGrammar grammar_of(const ReadingsOptions& options) {
  const DecimalMark mark = options.decimal_comma ? DecimalMark::comma : DecimalMark::point;
  return {options.missing, options.trace, mark};
}

namespace {

std::unique_ptr<Readings> open_as(const ReadingsLayout& layout, std::unique_ptr<Table> table,
                                  std::unique_ptr<const ReadingsStations> known,
                                  const ReadingsOptions& options, Warnings& warnings) {
  const std::string file = table->file();
  const std::string column = layout.is_long ? table->header()[layout.value] : "";
  const AmountConversion conversion =
      conversion_of(options, {file, table->header_line(), column}, warnings);
  const ReadingsStations& stations = *known;
  ReadingsFindings findings(file, stations, options.ignore_unknown, warnings);
  findings.amounts_are_in(options.cumulative ? counted : conversion.millimetres);
  ReadingsSource source{std::move(table), std::move(known), grammar_of(options),
                        std::move(findings)};
  std::unique_ptr<Readings> readings;
  if (layout.is_long) {
    readings = std::make_unique<LongReadings>(std::move(source), layout);
  } else {
    readings = std::make_unique<WideReadings>(std::move(source), layout);
  }
  if (options.cumulative) {
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
