#include "files/rainfall/rainfall_folder.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "base/file.h"
#include "base/utf8.h"
#include "files/tables/packed_file.h"
#include "gdal/layers/formats.h"
#include "readings/published/swat_files.h"
#include "readings/published/usgs_rdb.h"
#include "text/csv_form.h"
#include "text/csv_records.h"

namespace thiessen {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& name) {
  std::error_code ignored;
  return name != "-" && fs::is_directory(name, ignored);
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    if (!name.starts_with('.') && !entry->is_directory(ignored))
      names.push_back(entry->path().string());
  }
  if (fault) throw Error(Message{folder, 0, "cannot read: " + fault.message(), ""});
  std::sort(names.begin(), names.end());
  return names;
}

bool is_dly_file(const std::string& name) {
  return lower_case(name).ends_with(".dly");
}

/// Whether a file is of a format that is read, be it packed or not. The other files of a shapefile
/// beside its .shp do not count.
bool is_read(const std::string& name, const std::vector<std::string>& names) {
  const std::string lower = lower_case(name);
  if (lower.ends_with(".zip")) return true;
  const bool packed = lower.ends_with(".gz");
  if (format_by_extension(packed ? lower.substr(0, lower.size() - 3) : lower) == nullptr)
    return false;
  return !lower.ends_with(".dbf") ||
         std::none_of(names.begin(), names.end(), [&](const std::string& other) {
           return lower_case(other) == lower.substr(0, lower.size() - 4) + ".shp";
         });
}

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

/// Whether a file is surely no table, such as a readme.txt. What cannot be looked at may be one.
bool is_prose(const std::string& name) {
  const std::string lower = lower_case(name);
  if (lower.ends_with(".json")) return !has_features(name);
  const std::string beginning = beginning_of_text(name, csv_beginning_bytes);
  return !beginning.empty() && !has_rows(beginning) && !is_usgs_rdb(beginning) &&
         swat_file(beginning) == SwatFile::none;
}

/// The names of some files without their folder, for a message.
std::string listed_names(const std::vector<std::string>& files) {
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(files.size(), most); ++i) {
    if (i > 0) text += i + 1 == files.size() ? " and " : ", ";
    text += fs::path(files[i]).filename().string();
  }
  if (files.size() > most) text += " and " + std::to_string(files.size() - most) + " more";
  return text;
}

std::vector<std::string> files_in(const std::string& folder, Warnings& warnings) {
  const std::vector<std::string> names = names_in(folder);
  if (std::any_of(names.begin(), names.end(), is_dly_file)) return {folder};
  std::vector<std::string> files;
  std::vector<std::string> others;
  for (const std::string& name : names)
    (is_read(name, names) && !is_prose(name) ? files : others).push_back(name);
  if (files.empty()) {
    throw Error(Message{folder, 0, "is a folder without a file of readings",
                        "readings are tables, or .dly files of GHCN-Daily"});
  }
  if (!others.empty()) {
    warnings.add_notice({folder, 0,
                         listed_names(others) + (others.size() == 1 ? " holds" : " hold") +
                             " no readings, and " + (others.size() == 1 ? "is" : "are") +
                             " passed over",
                         ""});
  }
  return files;
}

}  // namespace

std::vector<std::string> rainfall_files(const std::vector<std::string>& named, Warnings& warnings) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    if (!is_folder(name)) {
      files.push_back(name);
      continue;
    }
    for (std::string& file : files_in(name, warnings)) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace thiessen
