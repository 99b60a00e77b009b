#include "readings/published/usgs_rdb.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "base/iso_time.h"
#include "base/utf8.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

constexpr std::string_view precipitation = "00045";
constexpr std::string_view sum_of_day = "00006";

/// A zone as USGS's tz_cd has it, and how far it is ahead of UTC.
struct Zone {
  std::string_view name;
  int hours;
  bool is_summer;
};

constexpr std::array<Zone, 17> zones = {{{"UTC", 0, false},
                                         {"GMT", 0, false},
                                         {"AST", -4, false},
                                         {"ADT", -3, true},
                                         {"EST", -5, false},
                                         {"EDT", -4, true},
                                         {"CST", -6, false},
                                         {"CDT", -5, true},
                                         {"MST", -7, false},
                                         {"MDT", -6, true},
                                         {"PST", -8, false},
                                         {"PDT", -7, true},
                                         {"AKST", -9, false},
                                         {"AKDT", -8, true},
                                         {"HST", -10, false},
                                         {"SST", -11, false},
                                         {"GST", 10, false}}};

const Zone* zone_called(std::string_view name) {
  const auto found =
      std::ranges::find_if(zones, [&](const Zone& zone) { return zone.name == name; });
  return found == zones.end() ? nullptr : &*found;
}

/// The name of a zone's standard time.
std::string standard_name(const Zone& zone) {
  std::string name(zone.name);
  if (zone.is_summer) name[name.size() - 2] = 'S';
  return name;
}

bool is_header(const std::vector<std::string_view>& fields) {
  return fields.size() > 3 && fields[0] == "agency_cd" &&
         std::ranges::find(fields, "site_no") != fields.end() &&
         std::ranges::find(fields, "datetime") != fields.end();
}

/// Whether all fields are as 5s, 20d and 14n are.
bool is_row_of_formats(const std::vector<std::string_view>& fields) {
  return std::ranges::all_of(fields, [](std::string_view field) {
    return field.size() >= 2 && std::string_view("sdn").find(field.back()) < 3 &&
           field.find_first_not_of("0123456789") == field.size() - 1;
  });
}

/// What a column of daily values holds of each day, such as 00006 for the sum; empty for others.
std::string_view statistic_of(std::string_view column) {
  const auto parts = parted(column, '_');
  return parts.size() == 3 ? parts[2] : std::string_view();
}

std::optional<std::size_t> index_of(const std::vector<std::string_view>& names,
                                    std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

bool is_usgs_rain(std::string_view column) {
  const auto parts = parted(column, '_');
  return parts.size() >= 2 && parts[1] == precipitation &&
         (parts.size() == 2 || (parts.size() == 3 && parts[2] != "cd"));
}

const PublishedFormat& usgs_rdb_format() {
  static constexpr PublishedFormat format = {
      .name = "USGS's RDB",
      .columns = "site_no, datetime, precipitation",
      .station = "site_no",
      .time = "datetime",
      .value = "precipitation",
      .unit = "in",
      .missing = "Ice Eqp Bkw *** -- Ssn Mnt Dis Rat Dry Tst ZFL Rmp Fld Pmp Pr -999999"};
  return format;
}

bool is_usgs_rdb(std::string_view beginning) {
  if (!beginning.starts_with('#') && !beginning.starts_with("agency_cd\t")) return false;
  while (!beginning.empty()) {
    const std::string_view line = take_line(beginning);
    if (!line.starts_with('#') && !trimmed(line).empty()) return is_header(parted(line, '\t'));
  }
  return false;
}

bool has_usgs_rain(InputFile file) {
  TextLines lines(std::move(file));
  while (const auto line = lines.next()) {
    if (line->starts_with('#')) continue;
    const auto fields = parted(*line, '\t');
    if (is_header(fields) && std::ranges::any_of(fields, is_usgs_rain)) return true;
  }
  return false;
}

UsgsRdb::UsgsRdb(std::string file, OpenInput open, std::string wanted, Warnings& warnings)
    : file_(std::move(file)),
      open_(std::move(open)),
      wanted_(std::move(wanted)),
      warnings_(warnings),
      lines_(open_()) {}

std::unique_ptr<Table> UsgsRdb::again() const {
  auto table = std::make_unique<UsgsRdb>(file_, open_, wanted_, warnings_);
  table->told_ = told_;
  return table;
}

bool UsgsRdb::next(Row& row) {
  while (const auto line = lines_.next()) {
    if (line->starts_with('#') || trimmed(*line).empty()) continue;
    line_ = *line;
    const auto fields = parted(line_, '\t');
    if (is_header(fields)) {
      read_header(fields);
    } else if (!is_row_of_formats(fields) && read_row(fields, row)) {
      return true;
    }
  }
  if (header_line_ == 0 && complaints_.empty()) {
    complain(wanted_.empty()
                 ? "no column of precipitation (" + std::string(precipitation) + ") is in the file"
                 : "there is no column " + quoted(wanted_, 80));
  }
  std::exchange(complaints_, {}).throw_if_any();
  tell_zone();
  return false;
}

/// The column of precipitation among those of a site. Tells which it is where there are several,
/// and complains where a day's values are none of rain that fell: a mean or an extreme.
std::optional<std::size_t> UsgsRdb::rain_among(const std::vector<std::string_view>& names) {
  if (!wanted_.empty()) return index_of(names, wanted_);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (is_usgs_rain(names[i])) all.push_back(i);
  if (all.empty()) return std::nullopt;
  const auto is_amount = [&](std::size_t i) {
    const std::string_view statistic = statistic_of(names[i]);
    return statistic.empty() || statistic == sum_of_day;
  };
  const auto found = std::ranges::find_if(all, is_amount);
  if (found == all.end()) {
    const std::string first(names[all.front()]);
    complaints_.add({file_, lines_.line(),
                     "its daily precipitation " + quoted(first, 80) +
                         " is no sum of the day: that would be " + std::string(sum_of_day),
                     setting("value_field", first) + " reads it nonetheless"});
    return all.front();
  }
  if (all.size() > 1 && !std::exchange(told_->columns, true)) {
    std::vector<std::string> others;
    for (const std::size_t i : all)
      if (i != *found) others.emplace_back(names[i]);
    warnings_.add_notice({file_, lines_.line(),
                          "of its columns of precipitation " + quoted(names[*found], 80) +
                              " is read, and not " + listed(others),
                          setting("value_field") + " names another"});
  }
  return *found;
}

void UsgsRdb::tell_zone() {
  if (other_zone_.empty() || std::exchange(told_->zone, true)) return;
  warnings_.add_notice(
      {file_, 0, "its times in " + other_zone_ + " are brought to " + zone_ + ", as all are", ""});
}

void UsgsRdb::read_header(const std::vector<std::string_view>& names) {
  columns_ = {names.size(), *index_of(names, "site_no"), *index_of(names, "datetime"),
              index_of(names, "tz_cd"), rain_among(names)};
  if (columns_.rain && header_line_ == 0) header_line_ = lines_.line();
}

/// Reads a row of a site that has precipitation.
bool UsgsRdb::read_row(const std::vector<std::string_view>& fields, Row& row) {
  if (columns_.count > 0 && !columns_.rain) return false;
  if (fields.size() != columns_.count) {
    complain(columns_.count == 0
                 ? "a row of data stands before any header"
                 : "the row has " + std::to_string(fields.size()) +
                       " fields, and the header above it " + std::to_string(columns_.count));
    return false;
  }
  if (!read_time(fields)) return false;
  row.line = lines_.line();
  row.padded = false;
  row.fields = {fields[columns_.site], time_, fields[*columns_.rain]};
  return true;
}

bool UsgsRdb::read_time(const std::vector<std::string_view>& fields) {
  const std::string_view text = fields[columns_.time];
  time_ = text;
  if (!columns_.zone) return true;
  const std::string_view name = fields[*columns_.zone];
  const Zone* zone = zone_called(name);
  if (zone == nullptr) {
    complain("no such time zone: " + quoted(name, 40));
    return false;
  }
  if (zone_.empty()) {
    zone_ = standard_name(*zone);
    ahead_ = 60 * (zone->hours - (zone->is_summer ? 1 : 0));
  }
  const int later = ahead_ - 60 * zone->hours;
  if (later == 0) return true;
  if (other_zone_.empty()) other_zone_ = name;
  const ParsedTime read = parse_iso_time(text);
  if (!read) {
    complain("the time is none: " + quoted(text, 40));
    return false;
  }
  const std::int64_t seconds_later = std::int64_t{60} * later;
  time_ = time_text(clock_seconds(read.time) + seconds_later, TimePrecision::instant);
  std::ranges::replace(time_, 'T', ' ');
  return true;
}

void UsgsRdb::complain(std::string text) {
  complaints_.add({file_, lines_.line(), std::move(text), ""});
}

}  // namespace thiessen
