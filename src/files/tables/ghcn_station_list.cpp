#include "files/tables/ghcn_station_list.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "files/tables/packed_file.h"
#include "files/tables/within_limit.h"

namespace thiessen {
namespace {

struct Column {
  const char* name;
  std::size_t begin;
  std::size_t size;
};

// From NOAA's readme.txt of GHCN-Daily, section IV, whose columns count from 1.
constexpr std::array<Column, 9> columns = {{{"id", 0, 11},
                                            {"latitude", 12, 8},
                                            {"longitude", 21, 9},
                                            {"elevation", 31, 6},
                                            {"state", 38, 2},
                                            {"name", 41, 30},
                                            {"gsn_flag", 72, 3},
                                            {"hcn_crn_flag", 76, 3},
                                            {"wmo_id", 80, 5}}};
constexpr std::size_t elevation = 3;
constexpr std::string_view unknown_elevation = "-999.9";

std::string_view field_of(std::string_view line, const Column& column) {
  return column.begin < line.size() ? trimmed(line.substr(column.begin, column.size))
                                    : std::string_view();
}

bool is_station(std::string_view line) {
  const std::string_view id = line.substr(0, std::min(columns[0].size, line.size()));
  const auto in_id = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return id.size() == columns[0].size && std::all_of(id.begin(), id.end(), in_id) &&
         line.size() > columns[2].begin && line[columns[0].size] == ' ' &&
         is_within(field_of(line, columns[1]), 90) && is_within(field_of(line, columns[2]), 180);
}

}  // namespace

bool is_ghcn_station_list(const std::string& file) {
  constexpr std::size_t enough = 1024;
  const std::string beginning = beginning_of_text(file, enough);
  std::string_view text = beginning;
  return is_station(take_line(text));
}

GhcnStationList::GhcnStationList(const std::string& file) : file_(file), lines_(open_text(file)) {
  for (const Column& column : columns) header_.emplace_back(column.name);
}

bool GhcnStationList::next(Row& row) {
  while (const auto line = lines_.next()) {
    if (trimmed(*line).empty()) continue;
    if (!is_station(*line)) {
      complaints_.add({file_, lines_.line(),
                       "is no line of GHCN-Daily's list of stations: " + quoted(*line, 60), ""});
      continue;
    }
    line_ = *line;
    row.line = lines_.line();
    row.padded = false;
    row.fields.clear();
    for (const Column& column : columns) row.fields.push_back(field_of(line_, column));
    if (row.fields[elevation] == unknown_elevation) row.fields[elevation] = "";
    return true;
  }
  std::exchange(complaints_, {}).throw_if_any();
  return false;
}

}  // namespace thiessen
