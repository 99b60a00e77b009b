#include "readings/published/arcswat_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "base/calendar_days.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::array<std::string_view, 5> list_columns = {"ID", "NAME", "LAT", "LONG", "ELEVATION"};
constexpr double missing = -99;

/// The day that a text such as 20000228 names; nothing where it names none.
std::optional<IsoTime> day_of(std::string_view text) {
  if (text.size() != 8 || text.find_first_not_of("0123456789") != std::string_view::npos)
    return std::nullopt;
  if (text < "1800" || text > "2200") return std::nullopt;
  const std::string iso = std::string(text.substr(0, 4)) + '-' + std::string(text.substr(4, 2)) +
                          '-' + std::string(text.substr(6));
  const ParsedTime day = parse_iso_time(iso);
  return day ? std::optional(day.time) : std::nullopt;
}

bool is_rain(std::string_view text) {
  const auto number = parse_number(text);
  return number && (number.value >= 0 || number.value == missing);
}

bool is_list_header(std::string_view line) {
  const auto names = parted(line, ',');
  return std::ranges::equal(names, list_columns, equal_ignoring_case);
}

std::vector<ArcSwatGauge> gauges_of(const std::string& list, const OpenNamed& open) {
  const std::filesystem::path folder = std::filesystem::path(list).parent_path();
  TextLines lines(open(list));
  lines.next();
  Complaints complaints;
  std::vector<ArcSwatGauge> gauges;
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    const auto fields = parted(*line, ',');
    if (fields.size() != list_columns.size() || fields[0].empty() || fields[1].empty()) {
      complaints.add(
          {list, lines.line(), "no ID, NAME, LAT, LONG and ELEVATION: " + quoted(*line, 60), ""});
      continue;
    }
    std::string name(fields[1]);
    if (!lower_case(name).ends_with(".txt")) name += ".txt";
    gauges.push_back({std::string(fields[0]), (folder / name).string()});
  }
  complaints.throw_if_any();
  if (gauges.empty()) throw Error({list, 0, "it names no files", ""});
  return gauges;
}

}  // namespace

const PublishedFormat& arcswat_list_format() {
  static constexpr PublishedFormat format = {
      .name = "ArcSWAT's list of files of rain (ID,NAME,LAT,LONG,ELEVATION)",
      .columns = "station, date, precipitation",
      .station = "station",
      .time = "date",
      .value = "precipitation",
      .unit = "mm",
      .missing = "-99"};
  return format;
}

const PublishedFormat& arcswat_gauge_format() {
  static constexpr PublishedFormat format = {.name = "ArcSWAT's rain of a gauge (.txt)",
                                             .columns = "date, precipitation",
                                             .station = "",
                                             .time = "date",
                                             .value = "precipitation",
                                             .unit = "mm",
                                             .missing = "-99"};
  return format;
}

ArcSwatFile arcswat_file(std::string_view beginning) {
  const std::string_view first = trimmed(take_line(beginning));
  if (is_list_header(first)) return ArcSwatFile::list;
  return day_of(first) && is_rain(trimmed(take_line(beginning))) ? ArcSwatFile::gauge
                                                                 : ArcSwatFile::none;
}

ArcSwatRainfall::ArcSwatRainfall(std::string file, ArcSwatFile kind, OpenNamed open)
    : file_(std::move(file)), kind_(kind), open_(std::move(open)) {
  header_ = {"date", "precipitation"};
  if (kind_ == ArcSwatFile::list) {
    header_.insert(header_.begin(), "station");
    gauges_ = gauges_of(file_, open_);
  } else {
    gauges_.push_back({"", file_});
  }
}

std::vector<std::string> files_of_arcswat_list(const std::string& list, const OpenNamed& open) {
  std::vector<std::string> files;
  for (ArcSwatGauge& gauge : gauges_of(list, open)) files.push_back(std::move(gauge.file));
  return files;
}

std::unique_ptr<Table> ArcSwatRainfall::again() const {
  return std::make_unique<ArcSwatRainfall>(file_, kind_, open_);
}

bool ArcSwatRainfall::next(Row& row) {
  while (lines_ || open_next()) {
    const auto line = lines_->next();
    if (!line) {
      lines_.reset();
      continue;
    }
    value_ = trimmed(*line);
    if (value_.empty()) continue;
    date_ = time_text(seconds_, TimePrecision::day);
    seconds_ += seconds_of_day;
    if (!is_rain(value_)) {
      complaints_.add({lines_->file(), lines_->line(),
                       "no rain from 0 on, nor -99 for none: " + quoted(value_, 40), ""});
      continue;
    }
    row.padded = false;
    row.line = places_.number(lines_->line());
    row.fields = {date_, value_};
    if (kind_ == ArcSwatFile::list)
      row.fields.insert(row.fields.begin(), gauges_[next_gauge_ - 1].id);
    return true;
  }
  std::exchange(complaints_, {}).throw_if_any();
  return false;
}

/// Opens the file of the next gauge, and reads its first day.
bool ArcSwatRainfall::open_next() {
  if (next_gauge_ == gauges_.size()) return false;
  places_.begin(gauges_[next_gauge_].file);
  lines_.emplace(open_(gauges_[next_gauge_++].file));
  const std::string first(trimmed(lines_->next().value_or("")));
  const auto day = day_of(first);
  if (!day) {
    throw Error({lines_->file(), 1, "no first day such as 20000101: " + quoted(first, 40), ""});
  }
  seconds_ = clock_seconds(*day);
  return true;
}

}  // namespace thiessen
