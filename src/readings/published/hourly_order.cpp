#include "readings/published/hourly_order.h"

#include <algorithm>
#include <utility>

#include "base/iso_time.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::int64_t seconds_an_hour = 3'600;
/// Every month has a row of a station that reports, if only to say that its first hour is dry.
constexpr std::int64_t longest_without_a_row = std::int64_t{31} * 24;
constexpr std::string_view measurement = "Measurement Flag";

/// The hour of a time such as 20100101 01:00, counted from 1970 on; nothing where it is none.
std::optional<std::int64_t> hour_in(std::string_view text) {
  constexpr std::size_t digits_of_day = 8;
  const std::size_t blank = text.find(' ');
  if (blank != digits_of_day) return std::nullopt;
  const std::string iso = std::string(text.substr(0, 4)) + "-" + std::string(text.substr(4, 2)) +
                          "-" + std::string(text.substr(6, 2)) + "T" +
                          std::string(text.substr(blank + 1));
  const ParsedTime read = parse_iso_time(iso);
  if (!read || read.time.precision != TimePrecision::instant) return std::nullopt;
  const std::int64_t seconds = clock_seconds(read.time);
  if (seconds % seconds_an_hour != 0) return std::nullopt;
  return seconds / seconds_an_hour;
}

/// The hour as the order writes it.
std::string hour_text(std::int64_t hour) {
  const std::string iso = time_text(hour * seconds_an_hour, TimePrecision::instant);
  return iso.substr(0, 4) + iso.substr(5, 2) + iso.substr(8, 2) + " " + iso.substr(11, 5);
}

bool is_among(std::string_view flag, std::string_view flags) {
  return flag.size() == 1 && flags.find(flag) != std::string_view::npos;
}

}  // namespace

const PublishedFormat& hourly_order_format() {
  static constexpr PublishedFormat format = {
      .name = "an order of NOAA's hourly precipitation",
      .columns = "STATION, DATE, HPCP, Measurement Flag, Quality Flag",
      .station = "STATION",
      .time = "DATE",
      .value = "HPCP",
      .missing = "99999 999.99",
      .flags = "Quality Flag",
      .ordered_units = "0.01in 0.1mm",
      .unit_is_ordered = true,
      .times_end_steps = true};
  return format;
}

bool is_hourly_order_header(const std::vector<std::string>& header) {
  return published_column(header, "STATION") && published_column(header, "DATE") &&
         published_column(header, "HPCP") && published_column(header, measurement);
}

HourlyOrder::HourlyOrder(std::unique_ptr<Table> table)
    : table_(std::move(table)),
      station_(published_column(table_->header(), "STATION").value()),
      date_(published_column(table_->header(), "DATE").value()),
      value_(published_column(table_->header(), "HPCP").value()),
      flag_(published_column(table_->header(), measurement).value()),
      quality_(published_column(table_->header(), "Quality Flag")) {}

HourlyOrder::HourlyOrder(const HourlyOrder& other, std::unique_ptr<Table> table)
    : HourlyOrder(std::move(table)) {
  begun_ = other.begun_;
}

std::unique_ptr<Table> HourlyOrder::again() const {
  auto table = table_->again();
  if (!table) return nullptr;
  return std::unique_ptr<Table>(new HourlyOrder(*this, std::move(table)));
}

std::string HourlyOrder::unit(std::size_t field) const {
  return header_[field] == "HPCP" ? table_->unit(value_) : std::string();
}

RowPlace HourlyOrder::place(std::size_t number) const {
  const auto after = std::ranges::upper_bound(*begun_, number, {}, &Begun::number);
  return table_->place(after == begun_->begin() ? 0 : (after - 1)->line);
}

bool HourlyOrder::next(Row& row) {
  if (!read_ && !read_hour()) {
    std::exchange(complaints_, {}).throw_if_any();
    return false;
  }
  if (next_hour_ < read_->hour) {
    time_ = hour_text(next_hour_++);
    give(row, time_, is_gap_ || read_->ends_gap ? "" : "0", "");
    return true;
  }
  is_gap_ = read_->begins_gap;
  next_hour_ = read_->hour + 1;
  const Hour hour = *std::exchange(read_, std::nullopt);
  station_now_ = hour.station;
  time_ = hour.time;
  value_text_ = hour.value;
  quality_text_ = hour.quality;
  give(row, time_, value_text_, quality_text_);
  return true;
}

void HourlyOrder::give(Row& row, std::string_view time, std::string_view value,
                       std::string_view quality) {
  row.line = number_++;
  row.padded = false;
  row.fields = {station_now_, time, value, quality};
}

/// Reads on to the next row that can be read, and sees what lies before it.
bool HourlyOrder::read_hour() {
  while (table_->next(row_)) {
    auto hour = hour_of(row_);
    if (!hour) continue;
    const bool is_apart = hour->hour - next_hour_ > longest_without_a_row;
    if (hour->station != station_now_ || is_apart) {
      station_now_ = hour->station;
      next_hour_ = hour->hour;
      is_gap_ = false;
    }
    if (begun_->empty() || begun_->back().number < number_) begun_->push_back({number_, row_.line});
    read_ = std::move(hour);
    return true;
  }
  return false;
}

/// The hour of a row; nothing, with a complaint, where its time is none or goes back.
std::optional<HourlyOrder::Hour> HourlyOrder::hour_of(const Row& row) {
  const std::string_view time = trimmed(row.fields[date_]);
  const auto hour = hour_in(time);
  if (!hour) {
    complaints_.add({file(), row.line, "no hour such as 20100101 01:00: " + quoted(time, 40), ""});
    return std::nullopt;
  }
  const std::string_view station = trimmed(row.fields[station_]);
  if (station == station_now_ && *hour < next_hour_) {
    complaints_.add({file(), row.line,
                     "hour " + quoted(time, 40) + " of station " + quoted(station, 80) +
                         " is not after the one above it",
                     "sort the rows by station and time"});
    return std::nullopt;
  }
  const std::string_view flag = trimmed(row.fields[flag_]);
  const std::string_view value = trimmed(row.fields[value_]);
  const std::string_view quality = quality_ ? trimmed(row.fields[*quality_]) : std::string_view();
  Hour found;
  found.station = station;
  found.time = time;
  found.hour = *hour;
  found.begins_gap = is_among(flag, "[{a,");
  found.ends_gap = is_among(flag, "]}A");
  // A sum of hours is none of the last one.
  if (!is_among(flag, "A")) found.value = value;
  if (is_among(quality, "RQXq")) found.quality = quality;
  return found;
}

}  // namespace thiessen
