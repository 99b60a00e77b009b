#include "readings/readings_reader.h"

#include <utility>

#include "readings/readings_layout.h"
#include "readings/readings_long.h"
#include "readings/readings_wide.h"

namespace thiessen {

ReadingGrammar grammar_of(const ReadingsOptions& options) {
  const DecimalMark mark = options.decimal_comma ? DecimalMark::comma : DecimalMark::point;
  return {options.missing, options.trace, mark};
}

std::unique_ptr<Readings> open_readings(std::unique_ptr<Table> table,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings) {
  auto known = std::make_unique<const ReadingsStations>(
      stations, passed_over, IdJoin{options.ids_as_numbers, options.column_of});
  const ReadingsLayout layout = find_layout(*table, *known, options);
  ReadingsFindings findings(table->file(), *known, options.ignore_unknown, warnings);
  ReadingsSource source{std::move(table), std::move(known), grammar_of(options),
                        std::move(findings)};
  if (layout.is_long) return std::make_unique<LongReadings>(std::move(source), layout);
  return std::make_unique<WideReadings>(std::move(source), layout);
}

}  // namespace thiessen
