#include "files/rainfall/published_rainfall.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/utf8.h"
#include "files/tables/csv_file.h"
#include "files/tables/netcdf_rainfall.h"
#include "files/tables/netcdf_stations.h"
#include "files/tables/packed_file.h"
#include "files/tables/table_file.h"
#include "readings/published/month_rows.h"
#include "readings/published/published_format.h"
#include "readings/published/published_table.h"
#include "readings/published/swat_files.h"
#include "readings/published/usgs_rdb.h"
#include "readings/rain_unit.h"
#include "text/csv_form.h"

namespace thiessen {
namespace {

/// A table, and its format where it is a published one.
struct Recognised {
  std::unique_ptr<Table> table;
  const PublishedFormat* format = nullptr;
};

Recognised open_usgs(const std::string& file) {
  auto table = std::make_unique<UsgsRdb>(file, [file] { return open_text(file); });
  return {std::move(table), &usgs_rdb_format()};
}

/// Whether a text begins with a row of GHCN-Daily in place of a header.
bool begins_as_ghcn(std::string_view beginning) {
  std::string_view line = beginning.substr(0, beginning.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  const auto fields = parted(line, ',');
  return is_ghcn_row({fields.begin(), fields.end()});
}

Recognised open_ghcn_without_header(const std::string& file, CsvDialect said, Warnings& warnings) {
  const PublishedFormat& format = ghcn_without_header();
  said.separator = ',';
  for (const std::string_view number : parted(format.columns, ','))
    said.numbers.emplace_back(number);
  return {open_csv(file, said, {}, warnings), &format};
}

/// A text of a published format; no table where it is none.
Recognised open_text_format(const std::string& rainfall, const CsvDialect& said,
                            Warnings& warnings) {
  const std::string beginning = beginning_of_text(rainfall, csv_beginning_bytes);
  if (is_usgs_rdb(beginning)) return open_usgs(rainfall);
  if (const SwatFile kind = swat_file(beginning); kind != SwatFile::none)
    return {std::make_unique<SwatRainfall>(rainfall, kind, open_text), &swat_format()};
  if (begins_as_ghcn(beginning)) return open_ghcn_without_header(rainfall, said, warnings);
  return {};
}

Recognised open_by_content(const Source& rainfall, const ReadingsOptions& options,
                           Warnings& warnings) {
  if (!options.value_field.empty()) return {open_table(rainfall, warnings)};
  if (rainfall.layer.empty() && rainfall.where.empty()) {
    Recognised found = open_text_format(rainfall.file, rainfall.csv, warnings);
    if (found.table) return found;
  }
  auto table = open_table(rainfall, warnings);
  if (is_ana_header(table->header()))
    return {std::make_unique<MonthRows>(std::move(table)), &ana_format()};
  const PublishedFormat* format = format_of_header(table->header());
  return {std::move(table), format};
}

/// Opens a NetCDF of stations, whose variable says its unit.
RainfallTable open_netcdf(const std::string& file, ReadingsOptions options, Warnings& warnings) {
  auto table = std::make_unique<NetcdfRainfall>(file, options.value_field);
  const std::string& name = table->header()[2];
  const std::string& units = table->units();
  const auto unit = rain_unit(units);
  if (!units.empty() && !unit && !options.from_unit && !options.scale) {
    throw Error({file, 0,
                 "its variable " + quoted(name, 60) + " is in " + quoted(units, 40) +
                     ", which is no unit of rain that is known",
                 setting("from_unit") + " says what it is in, or " + setting("scale") +
                     " brings it there"});
  }
  warnings.add_notice({file, 0,
                       "read as a NetCDF of stations: rain is " + name +
                           (unit ? ", in " + unit->name() : std::string()),
                       ""});
  options.station_field = "station";
  options.time_fields = {"time"};
  options.value_field = name;
  if (!options.from_unit && !options.scale) options.from_unit = unit;
  return {std::move(table), std::move(options)};
}

}  // namespace

RainfallTable open_rainfall_table(const Source& rainfall, const ReadingsOptions& options,
                                  Warnings& warnings) {
  if (!options.keep_flagged && is_netcdf_of_stations(rainfall.file))
    return open_netcdf(rainfall.file, options, warnings);
  Recognised found = open_by_content(rainfall, options, warnings);
  if (options.keep_flagged && (found.format == nullptr || found.format->flags.empty())) {
    throw Error({rainfall.file, 0,
                 setting("keep_flagged") + " is for GHCN-Daily, whose values have flags of quality",
                 ""});
  }
  if (found.format == nullptr) return {std::move(found.table), options};
  tell_format(*found.format, *found.table, options, warnings);
  ReadingsOptions all = options_of(*found.format, *found.table, options);
  auto table =
      std::make_unique<PublishedTable>(std::move(found.table), *found.format, options, warnings);
  return {std::move(table), std::move(all)};
}

}  // namespace thiessen
