#include "files/rainfall/rainfall_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "files/rainfall/files_without_rain.h"
#include "files/rainfall/published_rainfall.h"
#include "files/rainfall/rainfall_folder.h"
#include "files/tables/skipped_lines.h"
#include "readings/dly/dly_files.h"
#include "readings/joined_readings.h"
#include "readings/readings_dly.h"
#include "readings/stations/heard_stations.h"
#include "readings/stations/station_in_name.h"
#include "readings/stations/unit_names.h"
#include "readings/steps/counter_readings.h"
#include "text/field_names.h"

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

Source source_of(const RainfallRequest& rainfall, const std::string& file) {
  Source source = rainfall.said;
  source.file = file;
  return source;
}

/// A table, and the id of the station that it is of where none of its columns tells one. The table
/// is null where nothing tells that either, and it may be passed over.
struct Placed {
  std::unique_ptr<Table> table;
  std::string id;
  ReadingsOptions options;  ///< with what is known of a published format
};

/// The station of a file of one: as the file calls it, or as its name does, or that of the archive
/// in which it stands. Empty where none is known.
std::string station_of_file(const RainfallTable& opened, const std::string& named,
                            const ReadingsStations& known, Warnings& warnings) {
  const std::string& file = opened.table->file();
  for (const std::string& told : opened.stations_told) {
    if (known.find(told).standing == ReadingsStations::Standing::unknown) continue;
    warnings.add_notice({file, 0, "its station is " + quoted(told, 80), ""});
    return told;
  }
  std::string id = station_in_name(file, known);
  if (id.empty() && file != named) id = station_in_name(named, known);
  if (!id.empty()) warnings.add_notice({file, 0, "its station stands in the file's name", ""});
  return id;
}

[[noreturn]] void fail_without_station(const RainfallTable& opened) {
  const std::string& file = opened.table->file();
  if (!opened.stations_told.empty()) {
    throw Error({file, 0,
                 "its station is called " + listed(opened.stations_told) + ", and so is none of " +
                     input("stations"),
                 setting("id") + " names the column of " + input("stations") +
                     " that has it; of several files " + setting("ignore_unknown") +
                     " passes over those of other stations"});
  }
  if (opened.is_of_one_station) {
    throw Error({file, 0, "it is of one station, and its name tells none of " + input("stations"),
                 "the station's id stands in the file's name, parted from the rest by _, -, . or a "
                 "blank"});
  }
  throw Error({file, opened.table->header_line(),
               "no column is one of stations or called as a station of " + input("stations") +
                   ", nor does the file's name tell one",
               setting("station_field") + " names a column, and " + setting("ignore_unknown") +
                   " passes over such files"});
}

Placed open_placed(const Source& source, const ReadingsStations& known,
                   const ReadingsOptions& options, Warnings& warnings) {
  RainfallTable opened = open_rainfall_table(source, options, warnings);
  opened.table = with_units_in_names(std::move(opened.table), known, opened.options);
  const bool tells_stations =
      !opened.is_of_one_station &&
      (!options.is_one_of_several || !opened.options.station_field.empty() ||
       !names_no_station(*opened.table, known));
  if (tells_stations) return {std::move(opened.table), "", std::move(opened.options)};
  std::string id = station_of_file(opened, source.file, known, warnings);
  if (!id.empty()) {
    opened.options.station_field = station_of_name;
    auto of_one = of_station(std::move(opened.table), id);
    return {std::move(of_one), std::move(id), std::move(opened.options)};
  }
  if (!options.ignore_unknown || !options.is_one_of_several) fail_without_station(opened);
  warnings.add({source.file, 0, "it tells no station that is known, and is passed over", ""});
  return {};
}

std::unique_ptr<Readings> open_dly(const Source& rainfall, std::span<const Station> stations,
                                   std::span<const std::string> passed_over,
                                   const ReadingsOptions& options, Warnings& warnings) {
  require_no_table_wanted(rainfall);
  auto readings = open_dly_readings(rainfall.file, stations, passed_over, options, warnings);
  if (!readings)
    throw NoRain({rainfall.file, 0, "no element tells of how many days its PRCP is", ""});
  return readings;
}

std::unique_ptr<Readings> open_one(const Source& rainfall, std::span<const Station> stations,
                                   std::span<const std::string> passed_over,
                                   const ReadingsOptions& options, Warnings& warnings) {
  if (is_dly(rainfall.file)) return open_dly(rainfall, stations, passed_over, options, warnings);
  const ReadingsStations known(stations, passed_over, {options.ids_as_numbers, {}});
  Placed one = open_placed(rainfall, known, options, warnings);
  return open_readings(std::move(one.table), stations, passed_over, one.options, warnings);
}

/// The same, whose faults of the header have a hint about lines that were skipped.
std::unique_ptr<Readings> open_alone(const Source& rainfall, std::span<const Station> stations,
                                     std::span<const std::string> passed_over,
                                     const ReadingsOptions& options, Warnings& warnings) {
  try {
    return open_one(rainfall, stations, passed_over, options, warnings);
  } catch (const NoRain& none) {
    if (options.read != AmountsRead::of_steps) throw;
    throw told_of_skip(none, rainfall);
  } catch (const Error& error) {
    throw told_of_skip(error, rainfall);
  }
}

/// The same of one file of several. Where it is of one station, its readings are of that alone.
JoinedReadings::Opened open_among_several(const Source& rainfall, std::span<const Station> stations,
                                          std::span<const std::string> passed_over,
                                          const ReadingsOptions& options, Warnings& warnings) {
  if (is_dly(rainfall.file)) return open_dly(rainfall, stations, passed_over, options, warnings);
  const ReadingsStations known(stations, passed_over, {options.ids_as_numbers, {}});
  Placed one = open_placed(rainfall, known, options, warnings);
  if (!one.table) return {};
  if (one.id.empty())
    return open_readings(std::move(one.table), stations, passed_over, one.options, warnings);
  const ReadingsStations::Found found = known.find(one.id);
  if (found.standing != ReadingsStations::Standing::known) return {};
  return {open_readings(std::move(one.table), stations.subspan(index(found.station), 1), {},
                        one.options, warnings),
          found.station};
}

/// The stations of one file, which is opened once more later. The format of each file says for
/// itself whether ids are joined as numbers.
ReportingStations heard_in(const Source& rainfall, std::span<const Station> stations,
                           std::span<const std::string> passed_over,
                           const ReadingsOptions& options) {
  Warnings told_later;
  const ReadingsStations known(stations, passed_over, {options.ids_as_numbers, {}});
  if (is_dly(rainfall.file)) {
    HeardStations heard(known);
    heard.look_through_dly(dly_files(rainfall.file), options.keep_flagged,
                           dly_element(options.read));
    return heard.heard();
  }
  const Placed one = open_placed(rainfall, known, options, told_later);
  if (!one.table) return ReportingStations(stations.size(), false);
  const ReadingsStations joined(stations, passed_over, {one.options.ids_as_numbers, {}});
  HeardStations heard(joined);
  heard.look_through(*one.table, one.options);
  return heard.heard();
}

/// The same of one file of several; nothing where it holds no rain.
std::optional<ReportingStations> heard_if_of_rain(const Source& rainfall,
                                                  std::span<const Station> stations,
                                                  std::span<const std::string> passed_over,
                                                  const ReadingsOptions& options) {
  try {
    return heard_in(rainfall, stations, passed_over, options);
  } catch (const NoRain&) {
    return std::nullopt;
  }
}

/// Whether a file is one that brings its bytes once.
bool is_stream(const std::string& file) {
  using Type = std::filesystem::file_type;
  std::error_code none;
  const Type kind = std::filesystem::status(file, none).type();
  return kind == Type::fifo || kind == Type::character || kind == Type::socket;
}

bool can_file_be_read_again(const std::string& file) {
  return file != "-" && !is_stream(file);
}

}  // namespace

std::string RainfallRequest::name() const {
  std::string first = files.front() == "-" ? "standard input" : files.front();
  if (files.size() == 1) return first;
  return first + " and " + std::to_string(files.size() - 1) +
         (files.size() == 2 ? " more file" : " more files");
}

std::unique_ptr<Readings> open_rainfall(const RainfallRequest& rainfall,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings) {
  const std::vector<std::string> names = rainfall_files(rainfall.files, rainfall.beside, warnings);
  const bool is_alone = rainfall.files.size() == 1 && names == rainfall.files;
  if (is_alone && !options.steps_by_calendar)
    return open_alone(source_of(rainfall, names[0]), stations, passed_over, options, warnings);
  ReadingsOptions of_each = options;
  of_each.is_one_of_several = !is_alone;
  std::vector<JoinedReadings::File> files;
  files.reserve(names.size());
  const auto all = std::make_shared<FilesWithoutRain>(names.size(), rainfall.name());
  for (const std::string& name : names) {
    const auto open = [=, source = source_of(rainfall, name)](Warnings& of_file) {
      if (!of_each.is_one_of_several)
        return JoinedReadings::Opened(open_alone(source, stations, passed_over, of_each, of_file));
      return open_among_several(source, stations, passed_over, of_each, of_file);
    };
    files.push_back({name, [=](Warnings& of_file) { return all->open_next(open, name, of_file); }});
  }
  auto joined =
      std::make_unique<JoinedReadings>(std::move(files), rainfall.name(), stations, warnings);
  if (options.is_beside_others) joined->is_beside_others();
  if (options.steps_may_differ) joined->steps_may_differ();
  if (!options.cumulative || is_alone) return joined;
  return std::make_unique<CounterReadings>(std::move(joined), rainfall.name(), stations, warnings);
}

bool is_fed(const RainfallRequest& rainfall) {
  if (rainfall.files.size() != 1) return false;
  return is_stream(rainfall.files[0] == "-" ? "/dev/stdin" : rainfall.files[0]);
}

bool can_be_read_again(const RainfallRequest& rainfall) {
  return std::all_of(rainfall.files.begin(), rainfall.files.end(), can_file_be_read_again);
}

ReportingStations stations_that_report(const RainfallRequest& rainfall,
                                       std::span<const Station> stations,
                                       std::span<const std::string> passed_over,
                                       const ReadingsOptions& options) {
  ReportingStations heard(stations.size(), false);
  Warnings told_later;
  try {
    const std::vector<std::string> names =
        rainfall_files(rainfall.files, rainfall.beside, told_later);
    ReadingsOptions of_each = options;
    of_each.is_one_of_several = rainfall.files.size() > 1 || names != rainfall.files;
    std::size_t silent = stations.size();
    bool has_rain = false;
    for (const std::string& name : names) {
      if (silent == 0) break;
      const auto of_file =
          heard_if_of_rain(source_of(rainfall, name), stations, passed_over, of_each);
      has_rain = has_rain || of_file;
      for (std::uint32_t s = 0; of_file && s < stations.size(); ++s) {
        if (!(*of_file)[StationIndex{s}] || heard[StationIndex{s}]) continue;
        heard.set(StationIndex{s}, true);
        --silent;
      }
    }
    const bool is_of_all =
        options.read == AmountsRead::of_steps || options.read == AmountsRead::totals;
    if (!has_rain) return ReportingStations(stations.size(), is_of_all);
  } catch (const Error&) {
    return ReportingStations(stations.size(), true);
  }
  return heard;
}

}  // namespace thiessen
