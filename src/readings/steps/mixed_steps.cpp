#include "readings/steps/mixed_steps.h"

#include <algorithm>
#include <cmath>

#include "base/enumeration.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t names_listed = 10;
constexpr std::size_t longest_time = 80;
constexpr std::int64_t shortest_month = 28 * seconds_of_day;  // seconds

}  // namespace

void MixedSteps::note(const ParsedTime& parsed, std::string_view time, std::size_t line,
                      std::span<const double> readings) {
  intervals_.note(parsed);
  if (intervals_.has_labels()) return;
  note_form(parsed.time, time, line, readings);
  if (!first_time_) first_time_ = parsed.time;
  if (in_months_ && !stand_alike_in_months(*first_time_, parsed.time)) count_in_seconds();
  const std::int64_t at = in_months_ ? month_number(parsed.time) : moment_seconds(parsed.time);
  note_readings(at, CalendarPlace(parsed.time), readings);
}

void MixedSteps::note_form(const IsoTime& time, std::string_view text, std::size_t line,
                           std::span<const double> readings) {
  const auto keep = [&](std::optional<Written>& written) {
    if (!written) written = Written{std::string(text), line};
  };
  keep(written_.at(static_cast<std::size_t>(time.precision)));
  if (time.precision == TimePrecision::instant) return keep(time.ahead_of_utc ? zoned_ : zoneless_);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!std::isnan(readings[i]))
      gauges_[i].coarsest = std::min(gauges_[i].coarsest, time.precision);
  }
}

void MixedSteps::note_readings(std::int64_t at, const CalendarPlace& calendar,
                               std::span<const double> readings) {
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (std::isnan(readings[i])) continue;
    gauges_[i].readings.note(at);
    gauges_[i].monthly.note(calendar);
  }
}

/// Months were counted, and the times stand at other days after all. What a gauge's months were
/// apart is forgotten; a gauge with one reading loses nothing.
void MixedSteps::count_in_seconds() {
  in_months_ = false;
  const std::int64_t first_month = month_number(*first_time_);
  for (Gauge& gauge : gauges_) {
    const bool one = gauge.readings.count() == 1 && gauge.readings.last() == first_month;
    gauge.readings = {};
    if (one) gauge.readings.note(moment_seconds(*first_time_));
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
  std::vector<std::string> all_ids;
  all_ids.reserve(coarse.size());
  for (const StationIndex s : coarse) all_ids.push_back(stations[index(s)].id);
  const std::string ids = names_up_to(names_listed, all_ids, longest_time);
  const std::string subject =
      coarse.size() == 1 ? "station " + ids + " reports " : "stations " + ids + " report ";
  return {file, 0, subject + how + ": steps of two lengths in one table",
          setting("totals") +
              " reads the longer steps where they stand in a file of their own, and spreads each "
              "over the shorter ones; " +
              setting("stations_where") + " keeps gauges of one kind"};
}

template <typename IsCoarse>
std::vector<StationIndex> MixedSteps::gauges_that(const IsCoarse& is_coarse) const {
  std::vector<StationIndex> coarse;
  for (std::uint32_t i = 0; i < gauges_.size(); ++i) {
    if (is_coarse(gauges_[i])) coarse.push_back(StationIndex{i});
  }
  return coarse;
}

std::optional<Message> MixedSteps::mixed_forms(const std::string& file,
                                               std::span<const Station> stations) const {
  const auto& [years, months, days, instants] = written_;
  const std::optional<Written>& fine = instants ? instants : days;
  const std::optional<Written>& coarse = instants && days ? days : months ? months : years;
  if (!fine || !coarse) return std::nullopt;
  const TimePrecision finer = instants ? TimePrecision::instant : TimePrecision::day;
  const auto gauges = gauges_that([&](const Gauge& gauge) { return gauge.coarsest < finer; });
  if (gauges.empty()) return std::nullopt;
  const bool is_day = &coarse == &days;
  Message message =
      mixed(file, stations, gauges,
            std::string("at times without a ") + (is_day ? "clock" : "day") + ", such as " +
                quoted(coarse->time, longest_time) + ", beside times with one, such as " +
                quoted(fine->time, longest_time));
  if (is_day) message.hint += ", where midnights have not lost their 00:00";
  return message;
}

/// How often gauges are silent at a step, but for some; by the rule of succession, so that nothing
/// is held to be certain.
double MixedSteps::share_silent(const std::vector<StationIndex>& but_for) const {
  std::size_t readings = 0;
  for (const Gauge& gauge : gauges_) readings += gauge.readings.count();
  for (const StationIndex gauge : but_for) readings -= gauges_[index(gauge)].readings.count();
  const auto steps = static_cast<double>(intervals_.times() * (gauges_.size() - but_for.size()));
  return (std::max(0.0, steps - static_cast<double>(readings)) + 1) / (steps + 2);
}

/// Leaves out the gauges whose readings may stand so by chance: where a gauge is silent at random,
/// all steps between its readings have to be silent for that. `in_steps` gives how many of the
/// file's steps a gauge's readings are apart.
template <typename InSteps>
void MixedSteps::leave_chance_out(std::vector<StationIndex>& coarse,
                                  const InSteps& in_steps) const {
  constexpr double files_by_chance = 0.01;
  const double silent = share_silent(coarse);
  std::erase_if(coarse, [&](StationIndex station) {
    const Gauge& gauge = gauges_[index(station)];
    const auto between = static_cast<double>(in_steps(gauge) - 1) * (gauge.readings.count() - 1);
    return static_cast<double>(gauges_.size()) * std::pow(silent, between) >= files_by_chance;
  });
}

std::optional<Message> MixedSteps::fault(const std::string& file,
                                         std::span<const Station> stations) const {
  if (intervals_.has_labels()) return std::nullopt;
  if (auto zones = mixed_zones(file)) return zones;
  if (auto forms = mixed_forms(file, stations)) return forms;
  const std::optional<StepLength> step = intervals_.step();
  if (!step || (step->months > 0) != in_months_) return std::nullopt;
  const std::int64_t length = in_months_ ? step->months : step->seconds;
  const auto told = [&](const std::vector<StationIndex>& gauges, const auto& apart, bool months) {
    std::int64_t longest = 0;
    for (const StationIndex gauge : gauges)
      longest = std::max(longest, apart(gauges_[index(gauge)]));
    return mixed(file, stations, gauges,
                 "every " + text_of(months ? StepLength{longest, 0} : StepLength{0, longest}) +
                     " in a file whose step is " + text_of(*step));
  };
  const auto apart = [](const Gauge& gauge) { return gauge.readings.apart(); };
  auto coarse = gauges_that([&](const Gauge& gauge) {
    return apart(gauge) >= 2 * length && apart(gauge) % length == 0 &&
           gauge.readings.fill_their_steps();
  });
  leave_chance_out(coarse, [&](const Gauge& gauge) { return apart(gauge) / length; });
  if (!coarse.empty()) return told(coarse, apart, in_months_);
  if (in_months_) return std::nullopt;
  const auto months_apart = [](const Gauge& gauge) { return gauge.monthly.months().apart(); };
  auto monthly = gauges_that([&](const Gauge& gauge) {
    return gauge.monthly.stand_alike() && months_apart(gauge) > 0 &&
           gauge.monthly.months().fill_their_steps();
  });
  leave_chance_out(
      monthly, [&](const Gauge& gauge) { return months_apart(gauge) * shortest_month / length; });
  if (monthly.empty()) return std::nullopt;
  return told(monthly, months_apart, true);
}

}  // namespace thiessen
