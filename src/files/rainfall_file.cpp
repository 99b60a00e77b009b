#include "files/rainfall_file.h"

#include <filesystem>
#include <system_error>

#include "files/table_file.h"
#include "readings/dly_files.h"
#include "readings/heard_stations.h"
#include "readings/readings_dly.h"

namespace thiessen {

std::unique_ptr<Readings> open_rainfall(const std::string& rainfall, const CsvDialect& said,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings) {
  if (is_dly(rainfall)) {
    return open_dly_readings(rainfall, stations, passed_over, options, warnings);
  }
  if (options.keep_flagged) {
    throw Error({rainfall, 0, setting("keep_flagged") + " is for .dly files of GHCN-Daily", ""});
  }
  return open_readings(open_table(rainfall, said, warnings), stations, passed_over, options,
                       warnings);
}

bool can_be_read_again(const std::string& rainfall) {
  if (rainfall == "-") return false;
  using Type = std::filesystem::file_type;
  std::error_code none;
  const Type kind = std::filesystem::status(rainfall, none).type();
  return kind != Type::fifo && kind != Type::character && kind != Type::socket;
}

ReportingStations stations_that_report(const std::string& rainfall, const CsvDialect& said,
                                       std::span<const Station> stations,
                                       std::span<const std::string> passed_over,
                                       const ReadingsOptions& options) {
  const ReadingsStations known(stations, passed_over, {options.ids_as_numbers, {}});
  HeardStations heard(known);
  Warnings told_later;  // the file is opened once more
  try {
    if (is_dly(rainfall)) {
      heard.look_through_dly(dly_files(rainfall), options.keep_flagged);
    } else {
      heard.look_through(*open_table(rainfall, said, told_later), options);
    }
  } catch (const Error&) {
    return ReportingStations(stations.size(), true);
  }
  return heard.heard();
}

}  // namespace thiessen
