#include "files/tables/netcdf_times.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/calendar_days.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"
#include "text/field_names.h"

namespace thiessen {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 18U;  ///< times that are read at once
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double longest_time = 1e12;  // seconds

struct UnitName {
  std::string_view name;
  double seconds;
};

/// What times are counted in, as UDUNITS calls it.
constexpr std::array<UnitName, 17> unit_names = {{{"day", seconds_of_day},
                                                  {"days", seconds_of_day},
                                                  {"d", seconds_of_day},
                                                  {"hour", 3600},
                                                  {"hours", 3600},
                                                  {"hr", 3600},
                                                  {"hrs", 3600},
                                                  {"h", 3600},
                                                  {"minute", 60},
                                                  {"minutes", 60},
                                                  {"min", 60},
                                                  {"mins", 60},
                                                  {"second", 1},
                                                  {"seconds", 1},
                                                  {"sec", 1},
                                                  {"secs", 1},
                                                  {"s", 1}}};

/// Takes up to so many digits off the front of a text; nothing where it begins with none.
std::optional<int> take_number(std::string_view& text, std::size_t most_digits) {
  std::size_t digits = 0;
  int number = 0;
  while (digits < text.size() && text[digits] >= '0' && text[digits] <= '9') {
    if (++digits > most_digits) return std::nullopt;
    number = 10 * number + (text[digits - 1] - '0');
  }
  if (digits == 0) return std::nullopt;
  text.remove_prefix(digits);
  return number;
}

bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

std::string digits(int number, std::size_t count) {
  const std::string text = std::to_string(number);
  return std::string(count - std::min(count, text.size()), '0') + text;
}

/// Takes a date and a clock off the front of a text, with fewer digits than ISO 8601 wants; the
/// result is as that wants it, and empty where there is none.
std::string take_moment(std::string_view& text) {
  const auto year = take_number(text, 4);
  const auto month = year && take(text, '-') ? take_number(text, 2) : std::nullopt;
  const auto day = month && take(text, '-') ? take_number(text, 2) : std::nullopt;
  if (!day) return {};
  std::string moment = digits(*year, 4) + "-" + digits(*month, 2) + "-" + digits(*day, 2) + "T";
  if (!take(text, 'T')) text = trimmed(text);
  const auto hour = take_number(text, 2);
  const auto minute = hour && take(text, ':') ? take_number(text, 2) : std::optional(0);
  const auto second = minute && take(text, ':') ? take_number(text, 2) : std::optional(0);
  if (!minute || !second) return {};
  if (take(text, '.')) text.remove_prefix(std::min(text.find_first_not_of('0'), text.size()));
  return moment + digits(hour.value_or(0), 2) + ":" + digits(*minute, 2) + ":" + digits(*second, 2);
}

/// A zone's offset in minutes: UTC, Z, +1:00, +01:00, -0330, -6, or nothing.
std::optional<int> zone_offset(std::string_view text) {
  text = trimmed(text);
  for (const std::string_view name : {"", "UTC", "GMT", "Z"}) {
    if (equal_ignoring_case(text, name)) return 0;
  }
  const bool is_behind = text.starts_with('-');
  if (!take(text, '-')) take(text, '+');
  const std::size_t before = text.size();
  const auto first = take_number(text, 4);
  if (!first) return std::nullopt;
  const bool is_joined = before - text.size() > 2;
  const int hours = is_joined ? *first / 100 : *first;
  const auto minutes = is_joined         ? std::optional(*first % 100)
                       : take(text, ':') ? take_number(text, 2)
                                         : std::optional(0);
  if (!minutes || !text.empty() || hours > 23 || *minutes > 59) return std::nullopt;
  return (is_behind ? -1 : 1) * (60 * hours + *minutes);
}

void require_calendar(const NetcdfStations& stations) {
  const std::string calendar = lower_case(stations.attribute(stations.time()->number, "calendar"));
  for (const std::string_view known : {"", "standard", "gregorian", "proleptic_gregorian"}) {
    if (calendar == known) return;
  }
  stations.fail("its calendar is " + quoted(calendar, 40) + ", whose days are not ours");
}

}  // namespace

ParsedTimeUnit parse_time_unit(std::string_view text) {
  constexpr std::string_view since = " since ";
  const std::size_t parting = lower_case(text).find(since);
  const std::string_view name = trimmed(text.substr(0, parting));
  const auto* const known = std::ranges::find_if(
      unit_names, [&](const UnitName& one) { return equal_ignoring_case(one.name, name); });
  if (known == unit_names.end() || parting == std::string_view::npos) {
    return {std::nullopt, "times are counted in " + quoted(name, 40) + ", which is not known",
            "write them anew in days, hours, minutes or seconds: months and years are not all of "
            "one length"};
  }
  std::string_view rest = trimmed(text.substr(parting + since.size()));
  const std::string origin(rest);
  const ParsedTime read = parse_iso_time(take_moment(rest));
  const std::optional<int> zone = zone_offset(rest);
  if (!read || !zone) {
    return {std::nullopt, "times are counted from " + quoted(origin, 40) + ", which is no time",
            "wanted: a date, or a date, a clock and a zone, such as 2020-01-01 00:00:00 +01:00"};
  }
  NetcdfTimeUnit unit{known->seconds, clock_seconds(read.time), std::nullopt};
  if (*zone != 0) unit.ahead_of_utc = zone;
  return {unit, {}, {}};
}

NetcdfTimes::NetcdfTimes(const NetcdfStations& stations) : stations_(stations) {
  if (stations.time() == nullptr) stations.fail("it has no variable of times");
  require_calendar(stations);
  const std::size_t dimensions = stations.time()->dimensions.size();
  if (dimensions == 0 || dimensions > 2) stations.fail("its times have no dimension");
  ParsedTimeUnit read = parse_time_unit(stations.attribute(stations.time()->number, "units"));
  if (!read.unit) stations.fail(std::move(read.fault), std::move(read.hint));
  unit_ = *read.unit;
  fill_ = stations.number(stations.time()->number, "_FillValue");
  find_bounds();
  look_through();
}

/// Finds the variable of the bounds, which has a pair for each time.
void NetcdfTimes::find_bounds() {
  const NetcdfStations::Variable& time = *stations_.time();
  const std::string name = stations_.attribute(time.number, "bounds");
  if (name.empty()) return;
  const auto known = std::ranges::find_if(
      stations_.variables(), [&](const NetcdfStations::Variable& one) { return one.name == name; });
  std::vector<int> wanted = time.dimensions;
  const bool is_there = known != stations_.variables().end();
  if (is_there && !known->dimensions.empty()) wanted.push_back(known->dimensions.back());
  if (!is_there || known->dimensions != wanted || stations_.length_of(wanted.back()) != 2) {
    bounds_in_words_ = "the bounds of its times, " + quoted(name, 60) +
                       (is_there ? ", are no pairs" : ", are not in it");
    return;
  }
  const std::string units = stations_.attribute(known->number, "units");
  if (!units.empty() && units != stations_.attribute(time.number, "units")) {
    stations_.fail("its times are counted in another unit than their bounds, " + quoted(name, 60),
                   "CF wants them alike");
  }
  bounds_ = &*known;
}

std::vector<double> NetcdfTimes::values_of(int variable, std::span<const std::size_t> begin,
                                           std::span<const std::size_t> size) const {
  std::size_t count = 1;
  for (const std::size_t one : size) count *= one;
  std::vector<double> values(count);
  if (count == 0) return values;
  stations_.check(
      nc_get_vara_double(stations_.file(), variable, begin.data(), size.data(), values.data()));
  return values;
}

std::vector<double> NetcdfTimes::read(std::span<const std::size_t> begin,
                                      std::span<const std::size_t> size) const {
  std::vector<double> times = values_of(stations_.time()->number, begin, size);
  if (reads_bounds_) {
    std::vector<std::size_t> from(begin.begin(), begin.end());
    std::vector<std::size_t> pairs(size.begin(), size.end());
    from.push_back(0);
    pairs.push_back(2);
    const std::vector<double> bounds = values_of(bounds_->number, from, pairs);
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] != fill_) times[i] = std::min(bounds[2 * i], bounds[2 * i + 1]);
    }
  }
  for (double& time : times) {
    if (time == fill_) time = none;
  }
  return times;
}

/// Reads all times, and their bounds, to see what is common to them.
void NetcdfTimes::look_through() {
  const std::vector<int>& dimensions = stations_.time()->dimensions;
  const std::size_t length = stations_.length_of(dimensions.back());
  const std::size_t rows = dimensions.size() == 2 ? stations_.length_of(dimensions.front()) : 1;
  Places places;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t done = 0; done < length; done += block_size) {
      std::vector<std::size_t> begin = {row, done};
      std::vector<std::size_t> size = {1, std::min(block_size, length - done)};
      if (dimensions.size() == 1) {
        begin.erase(begin.begin());
        size.erase(size.begin());
      }
      const std::vector<double> times = read(begin, size);
      begin.push_back(0);
      size.push_back(2);
      const std::vector<double> bounds =
          bounds_ == nullptr ? std::vector<double>() : values_of(bounds_->number, begin, size);
      look_at(times, bounds, places);
    }
  }
  if (bounds_ != nullptr) settle(places);
}

void NetcdfTimes::look_at(std::span<const double> times, std::span<const double> bounds,
                          Places& places) {
  constexpr double rounding = 1e-6;  // of a step, for bounds may be numbers of other precision
  for (std::size_t i = 0; i < times.size(); ++i) {
    are_midnights_ = are_midnights_ && is_midnight(times[i]);
    if (bounds.empty() || std::isnan(times[i])) continue;
    const auto [begin, end] = std::minmax(bounds[2 * i], bounds[2 * i + 1]);
    begin_at_midnight_ = begin_at_midnight_ && is_midnight(begin);
    const double near = rounding * (end - begin);
    if (!(near > 0)) continue;
    ++places.all;
    if (std::fabs(times[i] - begin) <= near) ++places.begin;
    if (std::fabs(times[i] - end) <= near) ++places.end;
  }
}

/// Settles what the times are of their steps.
void NetcdfTimes::settle(const Places& places) {
  if (places.all == 0) return;
  const std::string& name = bounds_->name;
  if (places.begin == places.all) {
    stamp_ = Stamp::begin;
    bounds_in_words_ = "its times begin their steps, as " + name + " has them";
  } else if (places.end == places.all) {
    stamp_ = Stamp::end;
    bounds_in_words_ = "its times end their steps, as " + name + " has them";
  } else {
    stamp_ = Stamp::begin;
    reads_bounds_ = true;
    bounds_in_words_ = "its times are those at which " + name + " has its steps begin";
  }
}

bool NetcdfTimes::is_midnight(double time) const {
  const double seconds = time * unit_.seconds;
  if (!(std::fabs(seconds) < longest_time)) return true;  // it is none, and no step either
  return (unit_.origin + std::llround(seconds)) % seconds_of_day == 0;
}

std::string NetcdfTimes::text_of(double time) const {
  const double seconds = time * unit_.seconds;
  if (!(std::fabs(seconds) < longest_time)) stations_.fail("no time: " + shortest_text(time));
  const std::int64_t moment = unit_.origin + std::llround(seconds);
  const bool midnights = reads_bounds_ ? begin_at_midnight_ : are_midnights_;
  if (unit_.is_in_days() && midnights && stamp_ != Stamp::end)
    return time_text(moment, TimePrecision::day);
  std::string text = time_text(moment, TimePrecision::instant);
  if (!unit_.ahead_of_utc) return text;
  IsoTime zoned = parse_iso_time(text).time;
  zoned.ahead_of_utc = unit_.ahead_of_utc;
  return iso_text(zoned);
}

}  // namespace thiessen
