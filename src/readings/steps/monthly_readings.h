#pragma once

#include <cstdint>

#include "base/iso_time.h"
#include "readings/steps/spaced_readings.h"

namespace thiessen {

/// Where a time stands in the calendar.
struct CalendarPlace {
  explicit CalendarPlace(const IsoTime& time);

  std::int64_t month;  ///< counted from the year 0
  int day;
  std::int64_t clock;  ///< nanoseconds from midnight
  bool at_end;         ///< on the month's last day
};

/// Watches whether all readings of a gauge stand alike in their months: on one day and clock, or
/// all on the months' last days, and one in each.
class MonthlyReadings {
 public:
  /// Takes note of a reading.
  void note(const CalendarPlace& place) {
    if (alike_) note_while_alike(place);
  }

  bool stand_alike() const { return alike_; }
  /// The months of the readings, as long as these stood alike.
  const SpacedReadings& months() const { return months_; }

 private:
  void note_while_alike(const CalendarPlace& place);

  SpacedReadings months_;
  std::int64_t clock_ = 0;  ///< of the first reading
  int day_ = 0;
  bool at_end_ = false;
  bool alike_ = true;
};

}  // namespace thiessen
