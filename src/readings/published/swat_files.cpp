#include "readings/published/swat_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "base/calendar_days.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"
#include "readings/published/swat_steps.h"

namespace thiessen {
namespace {

constexpr std::size_t label_width = 7;
constexpr std::size_t value_width = 5;
constexpr std::size_t heads_of_gauge = 3;
constexpr std::size_t heads_of_gauges = 4;

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

bool has_label(std::string_view line, std::string_view label) {
  return equal_ignoring_case(line.substr(0, label.size()), label);
}

/// What stands in a place of the columns that follow a label.
std::string_view column_of(std::string_view line, std::size_t column) {
  const std::size_t begin = label_width + column * value_width;
  return begin < line.size() ? trimmed(line.substr(begin, value_width)) : std::string_view();
}

std::optional<int> whole_number(std::string_view text) {
  if (text.empty() || text.size() > 4) return std::nullopt;
  int number = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10 * number + (c - '0');
  }
  return number;
}

bool is_rain(std::string_view text) {
  constexpr double missing = -99;
  const auto number = parse_number(text);
  return number && (number.value >= 0 || number.value == missing);
}

std::vector<std::string> stations_of(std::string_view line) {
  constexpr std::string_view label = "Station";
  std::vector<std::string> stations;
  if (!has_label(line, label)) return stations;
  for (const std::string_view id : parted(line.substr(label.size()), ','))
    if (!id.empty()) stations.emplace_back(id);
  return stations;
}

std::string id_of(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

/// The numbers above the days of a gauge: years, steps a day, latitude, longitude, elevation.
std::vector<std::string> head_of_gauge(TextLines& lines) {
  for (std::size_t i = 0; i + 1 < heads_of_gauge; ++i) lines.next();
  const auto line = lines.next();
  const auto words = line ? words_of(*line) : std::vector<std::string_view>();
  if (words.size() != 5) {
    throw Error({lines.file(), lines.line(),
                 "five numbers are wanted: nbyr, tstep, lat, long and elev", ""});
  }
  return {words.begin(), words.end()};
}

SwatGauge gauge_of(const std::string& file, const OpenNamed& open) {
  TextLines lines(open(file));
  const auto head = head_of_gauge(lines);
  return {id_of(file), head[3], head[2], head[4]};
}

}  // namespace

const PublishedFormat& swat_format() {
  static constexpr PublishedFormat format = {.name = "rain of SWAT or SWAT+ (.pcp, pcp.cli)",
                                             .columns = "station, date, precipitation",
                                             .station = "station",
                                             .time = "date",
                                             .value = "precipitation",
                                             .unit = "mm",
                                             .missing = "-99"};
  return format;
}

SwatFile swat_file(std::string_view beginning) {
  const std::string_view first = take_line(beginning);
  const std::string_view second = take_line(beginning);
  const std::string_view third = take_line(beginning);
  if (has_label(first, "Station") && has_label(second, "Lat") && has_label(third, "Lon"))
    return SwatFile::gauges;
  const auto words = words_of(second);
  constexpr std::array<std::string_view, 5> heads = {"nbyr", "tstep", "lat", "long", "elev"};
  constexpr std::array<std::string_view, 5> others = {"nbyr", "tstep", "lat", "lon", "elev"};
  if (std::ranges::equal(words, heads) || std::ranges::equal(words, others)) return SwatFile::gauge;
  if (words.size() == 1 && words[0] == "filename" && trimmed(third).ends_with(".pcp"))
    return SwatFile::list;
  return SwatFile::none;
}

std::vector<std::string> files_of_swat_list(const std::string& list, const OpenNamed& open) {
  const std::filesystem::path folder = std::filesystem::path(list).parent_path();
  TextLines lines(open(list));
  lines.next();
  lines.next();
  std::vector<std::string> files;
  while (const auto line = lines.next()) {
    const std::string_view name = trimmed(*line);
    if (!name.empty()) files.push_back((folder / std::string(name)).string());
  }
  if (files.empty()) throw Error({list, 0, "it names no files", ""});
  return files;
}

SwatRainfall::SwatRainfall(std::string file, SwatFile kind, OpenNamed open)
    : file_(std::move(file)), kind_(kind), open_(std::move(open)) {
  if (kind_ == SwatFile::list) {
    files_ = files_of_swat_list(file_, open_);
  } else {
    files_ = {file_};
    if (kind_ == SwatFile::gauges) find_clocks();
  }
}

std::unique_ptr<Table> SwatRainfall::again() const {
  return std::make_unique<SwatRainfall>(file_, kind_, open_);
}

bool SwatRainfall::next(Row& row) {
  while (next_value_ == values_.size()) {
    if (step_ + 1 < steps_.size()) {
      go_to_step(step_ + 1);
    } else if (!next_line()) {
      std::exchange(complaints_, {}).throw_if_any();
      return false;
    }
  }
  row.line = row_number();
  row.padded = false;
  row.fields = {stations_[next_value_], date_, values_[next_value_]};
  ++next_value_;
  return true;
}

/// Finds the steps of a day that are shorter than it.
void SwatRainfall::find_clocks() {
  TextLines lines(open_(file_));
  for (std::size_t i = 0; i < heads_of_gauges; ++i) lines.next();
  clocks_ = swat_clocks(lines);
}

/// The number of a row, of which no other time's row has the same.
std::size_t SwatRainfall::row_number() {
  const std::size_t line = places_.number(lines_->line());
  return clocks_.empty() ? line : line * steps_a_line + step_;
}

/// Reads the next line that holds a day.
bool SwatRainfall::next_line() {
  while (true) {
    if (!lines_ && !open_next()) return false;
    const auto line = lines_->next();
    if (!line) {
      if (next_file_ == files_.size()) return false;
      lines_.reset();
    } else if (!trimmed(*line).empty() && next_day(*line)) {
      return true;
    }
  }
}

bool SwatRainfall::open_next() {
  if (next_file_ == files_.size()) return false;
  places_.begin(files_[next_file_]);
  lines_.emplace(open_(files_[next_file_++]));
  if (kind_ == SwatFile::gauges) {
    read_heads_of_gauges();
  } else {
    read_head_of_gauge();
  }
  return true;
}

void SwatRainfall::read_heads_of_gauges() {
  stations_ = stations_of(lines_->next().value_or(""));
  for (std::size_t i = 1; i < heads_of_gauges; ++i) lines_->next();
}

void SwatRainfall::read_head_of_gauge() {
  const auto head = head_of_gauge(*lines_);
  const auto steps = parse_number(head[1]);
  if (steps && steps.value > 1) {
    throw Error({lines_->file(), heads_of_gauge,
                 "its steps are shorter than a day (tstep " + head[1] + "), which is not read",
                 ""});
  }
  stations_ = {id_of(lines_->file())};
}

bool SwatRainfall::next_day(std::string_view line) {
  values_.clear();
  steps_.clear();
  next_value_ = 0;
  std::optional<int> year;
  std::optional<int> day;
  if (kind_ == SwatFile::gauges) {
    year = whole_number(trimmed(line.substr(0, 4)));
    day = line.size() > 4 ? whole_number(trimmed(line.substr(4, 3))) : std::nullopt;
    read_values_of_gauges(line);
  } else {
    const auto words = words_of(line);
    if (words.size() == 3) {
      year = whole_number(words[0]);
      day = whole_number(words[1]);
      values_.emplace_back(words[2]);
    }
  }
  const bool leap = year && *year % 4 == 0 && (*year % 100 != 0 || *year % 400 == 0);
  if (!year || *year < 1 || !day || *day < 1 || *day > (leap ? 366 : 365) || values_.empty()) {
    return complain((clocks_.empty() ? "no year, day of the year and rain: "
                                     : "no year, day of the year, clock and rain: ") +
                    quoted(line, 40));
  }
  const auto odd = std::ranges::find_if_not(values_, is_rain);
  if (odd != values_.end())
    return complain("no rain from 0 on, nor -99 for none: " + quoted(*odd, 40));
  IsoTime first;
  first.year = *year;
  return next_steps(line, clock_seconds(first) + (*day - 1) * seconds_of_day);
}

/// Finds the steps that a line of a day is of.
bool SwatRainfall::next_steps(std::string_view line, std::int64_t day) {
  constexpr std::int64_t minute_seconds = 60;
  if (clocks_.empty()) {
    steps_ = {day};
  } else if (const auto clock = swat_clock(line)) {
    steps_ = {day + *clock * minute_seconds};
  } else {
    const auto is_none = [](const std::string& value) { return parse_number(value).value <= 0; };
    if (!std::ranges::all_of(values_, is_none))
      return complain("rain of a whole day among steps that are shorter: " + quoted(line, 40));
    for (const int of_day : clocks_) steps_.push_back(day + of_day * minute_seconds);
  }
  go_to_step(0);
  return true;
}

void SwatRainfall::go_to_step(std::size_t step) {
  step_ = step;
  next_value_ = 0;
  date_ = time_text(steps_[step], clocks_.empty() ? TimePrecision::day : TimePrecision::instant);
}

void SwatRainfall::read_values_of_gauges(std::string_view line) {
  if (!clocks_.empty()) {
    if (swat_clock(line) || is_dry_day_of_swat(line))
      values_ = swat_values_of_step(line, stations_.size());
    return;
  }
  const std::size_t wanted = label_width + stations_.size() * value_width;
  if (stations_.empty() || line.size() > wanted || line.size() + value_width <= wanted) return;
  for (std::size_t i = 0; i < stations_.size(); ++i) values_.emplace_back(column_of(line, i));
}

bool SwatRainfall::complain(const std::string& text) {
  values_.clear();
  steps_.clear();
  complaints_.add({lines_->file(), lines_->line(), text, ""});
  return false;
}

std::vector<SwatGauge> swat_gauges(const std::string& file, SwatFile kind, const OpenNamed& open) {
  std::vector<SwatGauge> gauges;
  if (kind == SwatFile::gauge) return {gauge_of(file, open)};
  if (kind == SwatFile::list) {
    for (const std::string& one : files_of_swat_list(file, open))
      gauges.push_back(gauge_of(one, open));
    return gauges;
  }
  TextLines lines(open(file));
  for (const std::string& id : stations_of(lines.next().value_or("")))
    gauges.push_back({id, {}, {}, {}});
  for (std::string SwatGauge::*part :
       {&SwatGauge::latitude, &SwatGauge::longitude, &SwatGauge::elevation}) {
    const std::string line(lines.next().value_or(""));
    for (std::size_t i = 0; i < gauges.size(); ++i) gauges[i].*part = column_of(line, i);
  }
  return gauges;
}

}  // namespace thiessen
