#include "files/rainfall_file.h"

#include <filesystem>
#include <system_error>

#include "files/table_file.h"
#include "readings/dly_files.h"
#include "readings/heard_stations.h"
#include "readings/readings_dly.h"

namespace thiessen {
namespace {

/// Refuses a layer and a filter of rows where there are neither.
void require_no_table_wanted(const Source& rainfall) {
  const bool layer = !rainfall.layer.empty();
  if (!layer && rainfall.where.empty()) return;
  throw Error({rainfall.file, 0,
               setting(layer ? rainfall.layer_setting : rainfall.where_setting) +
                   " is of tables, and .dly files of GHCN-Daily are none",
               "leave it out: of these files PRCP alone is read"});
}

}  // namespace

std::unique_ptr<Readings> open_rainfall(const Source& rainfall, std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings) {
  if (is_dly(rainfall.file)) {
    require_no_table_wanted(rainfall);
    return open_dly_readings(rainfall.file, stations, passed_over, options, warnings);
  }
  if (options.keep_flagged) {
    throw Error(
        {rainfall.file, 0, setting("keep_flagged") + " is for .dly files of GHCN-Daily", ""});
  }
  return open_readings(open_table(rainfall, warnings), stations, passed_over, options, warnings);
}

bool can_be_read_again(const std::string& rainfall) {
  if (rainfall == "-") return false;
  using Type = std::filesystem::file_type;
  std::error_code none;
  const Type kind = std::filesystem::status(rainfall, none).type();
  return kind != Type::fifo && kind != Type::character && kind != Type::socket;
}

ReportingStations stations_that_report(const Source& rainfall, std::span<const Station> stations,
                                       std::span<const std::string> passed_over,
                                       const ReadingsOptions& options) {
  const ReadingsStations known(stations, passed_over, {options.ids_as_numbers, {}});
  HeardStations heard(known);
  Warnings told_later;  // the file is opened once more
  try {
    if (is_dly(rainfall.file)) {
      heard.look_through_dly(dly_files(rainfall.file), options.keep_flagged);
    } else {
      heard.look_through(*open_table(rainfall, told_later), options);
    }
  } catch (const Error&) {
    return ReportingStations(stations.size(), true);
  }
  return heard.heard();
}

}  // namespace thiessen
