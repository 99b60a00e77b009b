#include "rainfall/series/step_months.h"

#include "base/utf8.h"

namespace thiessen {

namespace {

/// A time within a step: midnight at the end of a step belongs to the day before.
std::optional<IsoTime> time_within(std::string_view time, const std::optional<WrittenTime>& written,
                                   Stamp stamp) {
  const ParsedTime parsed = calendar_time(time, written);
  if (!parsed) return std::nullopt;
  if (stamp != Stamp::end || parsed.time.precision != TimePrecision::instant) return parsed.time;
  return parse_iso_time(time_text(clock_seconds(parsed.time) - 1, TimePrecision::instant)).time;
}

}  // namespace

std::optional<std::size_t> month_of(std::string_view time,
                                    const std::optional<WrittenTime>& written, Stamp stamp) {
  const auto within = time_within(time, written, stamp);
  if (!within || within->precision == TimePrecision::year) return std::nullopt;
  return static_cast<std::size_t>(within->month - 1);
}

std::optional<int> year_of(std::string_view time, const std::optional<WrittenTime>& written,
                           Stamp stamp) {
  const auto within = time_within(time, written, stamp);
  return within ? std::optional<int>(within->year) : std::nullopt;
}

std::size_t StepMonths::of(std::string_view time, const std::optional<WrittenTime>& written,
                           std::size_t line) const {
  if (const auto month = month_of(time, written, stamp_)) return *month;
  throw Error(
      {file_, line,
       "time " + quoted(time, 80) + " tells no calendar month, and normals are of calendar months",
       "give normals of the year, or say with " + setting("time_format") +
           " how times are written"});
}

}  // namespace thiessen
