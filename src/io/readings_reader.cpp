#include "io/readings_reader.h"

#include <utility>

#include "io/dly_files.h"
#include "io/readings_dly.h"
#include "io/readings_layout.h"
#include "io/readings_long.h"
#include "io/readings_wide.h"
#include "io/table_file.h"

namespace thiessen {

std::unique_ptr<Readings> open_readings(std::unique_ptr<Table> table,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings) {
  auto known = std::make_unique<const ReadingsStations>(stations, passed_over);
  const ReadingsLayout layout = find_layout(*table, *known, options);
  const DecimalMark mark = options.decimal_comma ? DecimalMark::comma : DecimalMark::point;
  ReadingGrammar grammar(options.missing, options.trace, mark);
  ReadingsFindings findings(table->file(), *known, options.ignore_unknown, warnings);
  ReadingsSource source{std::move(table), std::move(known), std::move(grammar),
                        std::move(findings)};
  if (layout.is_long) return std::make_unique<LongReadings>(std::move(source), layout);
  return std::make_unique<WideReadings>(std::move(source), layout);
}

std::unique_ptr<Readings> open_rainfall(const std::string& rainfall, char separator,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings) {
  if (is_dly(rainfall)) {
    return open_dly_readings(rainfall, stations, passed_over, options, warnings);
  }
  if (options.keep_flagged) {
    throw Error({rainfall, 0, "--keep-flagged is for .dly files of GHCN-Daily", ""});
  }
  return open_readings(open_table(rainfall, separator), stations, passed_over, options, warnings);
}

}  // namespace thiessen
