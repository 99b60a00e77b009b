#include "files/tables/dwd_station_list.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/utf8.h"
#include "files/tables/packed_file.h"
#include "files/tables/within_limit.h"
#include "text/decoder.h"

namespace thiessen {
namespace {

constexpr std::array<std::string_view, 8> names = {"Stations_id",   "von_datum", "bis_datum",
                                                   "Stationshoehe", "geoBreite", "geoLaenge",
                                                   "Stationsname",  "Bundesland"};
constexpr std::size_t parted_by_blanks = 6;
constexpr std::size_t latitude = 4;
constexpr std::size_t longitude = 5;

/// Takes the first word from a text, and the blanks round it.
std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

/// Takes what stands before two blanks.
std::string_view take_name(std::string_view& text) {
  const std::size_t end = std::min(text.find("  "), text.size());
  const std::string_view name = text.substr(0, end);
  text = trimmed(text.substr(end));
  return name;
}

bool is_header(std::string_view line) {
  for (const std::string_view name : names) {
    if (!equal_ignoring_case(take_word(line), name)) return false;
  }
  return true;
}

}  // namespace

bool is_dwd_station_list(const std::string& file) {
  constexpr std::size_t enough = 1024;
  const std::string beginning = beginning_of_text(file, enough);
  std::string_view text = beginning;
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return is_header(take_line(text));
}

DwdStationList::DwdStationList(const std::string& file)
    : file_(file), header_(names.begin(), names.end()), lines_(open_text(file)) {
  lines_.next();
}

bool DwdStationList::next(Row& row) {
  while (const auto line = lines_.next()) {
    if (line->find_first_not_of("- \t") == std::string_view::npos) continue;
    line_ = find_invalid_utf8(*line) ? decoded(*line, "Latin-1") : std::string(*line);
    if (read(line_, row)) return true;
    complaints_.add(
        {file_, lines_.line(), "is no line of DWD's list of stations: " + quoted(line_, 60), ""});
  }
  std::exchange(complaints_, {}).throw_if_any();
  return false;
}

bool DwdStationList::read(std::string_view line, Row& row) const {
  row.line = lines_.line();
  row.padded = false;
  row.fields.clear();
  for (std::size_t i = 0; i < parted_by_blanks; ++i) row.fields.push_back(take_word(line));
  row.fields.push_back(take_name(line));
  row.fields.push_back(take_name(line));
  return is_within(row.fields[latitude], 90) && is_within(row.fields[longitude], 180);
}

}  // namespace thiessen
