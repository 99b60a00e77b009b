#include "readings/steps/monthly_readings.h"

#include "rainfall/series/step_length.h"

namespace thiessen {

CalendarPlace::CalendarPlace(const IsoTime& time)
    : month(month_number(time)),
      day(time.day),
      clock(((std::int64_t{60} * time.hour + time.minute) * 60 + time.second) * 1'000'000'000 +
            time.nanosecond),
      at_end(is_last_of_month(time)) {}

void MonthlyReadings::note_while_alike(const CalendarPlace& place) {
  if (months_.count() == 0) {
    day_ = place.day;
    clock_ = place.clock;
    at_end_ = place.at_end;
  } else {
    const bool same_day = place.day == day_ || (place.at_end && at_end_);
    alike_ = place.month != months_.last() && same_day && place.clock == clock_;
  }
  months_.note(place.month);
}

}  // namespace thiessen
