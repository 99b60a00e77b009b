#include "files/rainfall/rainfall_content.h"

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "base/utf8.h"
#include "files/tables/dwd_station_list.h"
#include "files/tables/ghcn_station_list.h"
#include "files/tables/netcdf_stations.h"
#include "files/tables/packed_file.h"
#include "readings/published/arcswat_files.h"
#include "readings/published/swat_files.h"
#include "readings/published/text_beginning.h"
#include "text/csv_form.h"
#include "text/csv_records.h"

namespace thiessen {
namespace {

/// Whether a text has a row of as many fields as its header, one of which begins as a number or a
/// time does: what is told of readings beside them has none.
bool has_rows(const std::string& beginning) {
  CsvHints hints;
  hints.is_all = beginning.size() < csv_beginning_bytes;
  const CsvForm form = find_csv_form(beginning, hints);
  const std::vector<CsvRecord> records = csv_records(beginning, form.header, hints.is_all);
  if (records.empty()) return false;
  const std::size_t fields = csv_fields(records[0], form.separator).size();
  const auto begins_as_number = [](std::string_view field) {
    const std::size_t digit = field.find_first_not_of("+-.");
    return digit != std::string_view::npos && field[digit] >= '0' && field[digit] <= '9';
  };
  return fields >= 2 && std::any_of(records.begin() + 1, records.end(), [&](const auto& record) {
           const auto row = csv_fields(record, form.separator);
           return row.size() == fields && std::ranges::any_of(row, begins_as_number);
         });
}

/// Whether a JSON may be one of features, and not of what is told of other files.
bool has_features(const std::string& name) {
  try {
    std::string beginning(csv_beginning_bytes, '\0');
    InputFile file(name);
    beginning.resize(file.read(beginning));
    return beginning.empty() || beginning.find("\"Feature") != std::string::npos;
  } catch (const Error&) {
    return true;  // whoever reads it says so
  }
}

/// Whether a text is in UTF-16, whose bytes tell nothing before they are decoded.
bool is_utf_16(std::string_view beginning) {
  return beginning.starts_with("\xFF\xFE") || beginning.starts_with("\xFE\xFF");
}

bool is_station_list(const std::string& file) {
  return is_dwd_station_list(file) || is_ghcn_station_list(file);
}

}  // namespace

RainfallContent rainfall_content(const std::string& file) {
  if (lower_case(file).ends_with(".json"))
    return has_features(file) ? RainfallContent::unknown : RainfallContent::none;
  if (is_netcdf_of_stations(file)) return RainfallContent::readings;
  const std::string beginning = beginning_of_text(file, csv_beginning_bytes);
  if (beginning.empty() || is_utf_16(beginning)) return RainfallContent::unknown;
  if (begins_as_readings(beginning)) return RainfallContent::readings;
  const bool is_table = has_rows(beginning) && !is_station_list(file);
  return is_table ? RainfallContent::unknown : RainfallContent::none;
}

std::vector<std::string> files_listed_in(const std::string& file) {
  const std::string name = lower_case(file);
  if (!name.ends_with(".cli") && !name.ends_with(".txt")) return {};
  const std::string beginning = beginning_of_text(file, csv_beginning_bytes);
  try {
    if (swat_file(beginning) == SwatFile::list) return files_of_swat_list(file, open_text);
    if (arcswat_file(beginning) == ArcSwatFile::list) return files_of_arcswat_list(file, open_text);
  } catch (const Error&) {
    // The error is met again, and reported, when the list is read.
  }
  return {};
}

bool lists_no_rain(const std::string& file) {
  const std::vector<std::string> files = files_listed_in(file);
  if (files.empty()) return false;
  const std::string beginning = beginning_of_text(files.front(), csv_beginning_bytes);
  if (beginning.empty()) return false;  // whoever reads it says why
  return swat_file(beginning) != SwatFile::gauge && arcswat_file(beginning) != ArcSwatFile::gauge;
}

}  // namespace thiessen
