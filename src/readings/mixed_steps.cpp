#include "readings/mixed_steps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t names_listed = 10;
constexpr std::size_t longest_time = 80;
constexpr std::uint32_t readings_that_tell = 3;

}  // namespace

void MixedSteps::note(std::string_view time, std::size_t line, std::span<const double> readings) {
  const ParsedTime parsed = parse_iso_time(trimmed(time));
  intervals_.note(parsed);
  if (intervals_.has_labels()) return;
  note_form(parsed.time, time, line, readings);
  if (!first_time_) first_time_ = parsed.time;
  if (in_months_ && !stand_alike_in_months(*first_time_, parsed.time)) count_in_seconds();
  note_readings(in_months_ ? month_number(parsed.time) : moment_seconds(parsed.time), readings);
}

void MixedSteps::note_form(const IsoTime& time, std::string_view text, std::size_t line,
                           std::span<const double> readings) {
  const auto keep = [&](std::optional<Written>& written) {
    if (!written) written = Written{std::string(text), line};
  };
  if (time.precision != TimePrecision::instant) {
    keep(clockless_);
    for (std::size_t i = 0; i < readings.size(); ++i)
      gauges_[i].by_days = gauges_[i].by_days || !std::isnan(readings[i]);
    return;
  }
  keep(clocked_);
  keep(time.ahead_of_utc ? zoned_ : zoneless_);
}

void MixedSteps::note_readings(std::int64_t at, std::span<const double> readings) {
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (std::isnan(readings[i])) continue;
    Gauge& gauge = gauges_[i];
    ++gauge.readings;
    if (gauge.last != never) {
      const std::int64_t apart = std::abs(at - gauge.last);
      if (apart != gauge.apart) gauge.apart = std::gcd(gauge.apart, apart);
      gauge.low = std::min(gauge.low, at);
      gauge.high = std::max(gauge.high, at);
    } else {
      gauge.low = gauge.high = at;
    }
    gauge.last = at;
  }
}

/// Months were counted, and the times stand at other days after all. What a gauge's months were
/// apart is forgotten; a gauge with one reading loses nothing.
void MixedSteps::count_in_seconds() {
  in_months_ = false;
  const std::int64_t first_month = month_number(*first_time_);
  for (Gauge& gauge : gauges_) {
    if (gauge.last == never) continue;
    const bool one = gauge.readings == 1 && gauge.last == first_month;
    gauge = {never, never, never, 0, 0, gauge.by_days};
    if (!one) continue;
    gauge.last = gauge.low = gauge.high = moment_seconds(*first_time_);
    gauge.readings = 1;
  }
}

std::optional<Message> MixedSteps::mixed_zones(const std::string& file) const {
  if (!zoned_ || !zoneless_) return std::nullopt;
  const bool zoned_first = zoned_->line < zoneless_->line;
  const Written& first = zoned_first ? *zoned_ : *zoneless_;
  const Written& second = zoned_first ? *zoneless_ : *zoned_;
  const std::string where = first.line > 0 ? " in line " + std::to_string(first.line) : "";
  return Message{file, second.line,
                 "time " + quoted(second.time, longest_time) +
                     (zoned_first ? " has no zone" : " has a zone") + ", and " +
                     quoted(first.time, longest_time) + where +
                     (zoned_first ? " has one" : " has none"),
                 "write all times with a zone, or none"};
}

Message MixedSteps::mixed(const std::string& file, std::span<const Station> stations,
                          const std::vector<StationIndex>& coarse, const std::string& how) const {
  std::string ids;
  for (std::size_t i = 0; i < std::min(coarse.size(), names_listed); ++i)
    ids += (i > 0 ? ", " : "") + quoted(stations[index(coarse[i])].id, longest_time);
  if (coarse.size() > names_listed)
    ids += " and " + std::to_string(coarse.size() - names_listed) + " more";
  const std::string subject =
      coarse.size() == 1 ? "station " + ids + " reports " : "stations " + ids + " report ";
  return {file, 0, subject + how + ": steps of two lengths in one table",
          setting("stations_where") + " keeps gauges of one kind"};
}

std::optional<Message> MixedSteps::fault(const std::string& file,
                                         std::span<const Station> stations) const {
  if (intervals_.has_labels()) return std::nullopt;
  if (auto zones = mixed_zones(file)) return zones;
  std::vector<StationIndex> coarse;
  const auto gather = [&](const auto& is_coarse) {
    for (std::uint32_t i = 0; i < gauges_.size(); ++i) {
      if (is_coarse(gauges_[i])) coarse.push_back(StationIndex{i});
    }
  };
  if (clocked_ && clockless_) {
    gather([](const Gauge& gauge) { return gauge.by_days; });
    if (coarse.empty()) return std::nullopt;
    return mixed(file, stations, coarse,
                 "at times without a clock, such as " + quoted(clockless_->time, longest_time) +
                     ", beside times with one, such as " + quoted(clocked_->time, longest_time));
  }
  const std::optional<StepLength> step = intervals_.step();
  if (!step || (step->months > 0) != in_months_) return std::nullopt;
  const std::int64_t length = in_months_ ? step->months : step->seconds;
  std::int64_t apart = 0;
  gather([&](const Gauge& gauge) {
    if (gauge.readings < readings_that_tell || gauge.apart < 2 * length ||
        gauge.apart % length != 0)
      return false;
    const std::int64_t places = (gauge.high - gauge.low) / gauge.apart + 1;
    if (places >= 2 * std::int64_t{gauge.readings}) return false;
    apart = std::max(apart, gauge.apart);
    return true;
  });
  if (coarse.empty()) return std::nullopt;
  const StepLength longest = in_months_ ? StepLength{apart, 0} : StepLength{0, apart};
  return mixed(file, stations, coarse,
               "every " + text_of(longest) + " in a file whose step is " + text_of(*step));
}

}  // namespace thiessen
