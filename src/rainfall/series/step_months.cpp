#include "rainfall/series/step_months.h"

#include "base/utf8.h"

namespace thiessen {

std::optional<std::size_t> month_of(std::string_view time,
                                    const std::optional<WrittenTime>& written, Stamp stamp) {
  const ParsedTime parsed = calendar_time(time, written);
  if (!parsed || parsed.time.precision == TimePrecision::year) return std::nullopt;
  IsoTime within = parsed.time;
  if (stamp == Stamp::end && within.precision == TimePrecision::instant)
    within = parse_iso_time(time_text(clock_seconds(within) - 1, TimePrecision::instant)).time;
  return static_cast<std::size_t>(within.month - 1);
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
