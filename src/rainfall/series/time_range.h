#pragma once

#include <optional>

#include "base/iso_time.h"

namespace thiessen {

/// The times from one to another, both included.
///
/// A limit that is a year, month or day holds all of it. It is compared with the date as the time
/// of a step writes it, so 24:00 belongs to the day that it ends. A limit with a time of day is a
/// moment (see order_of_moments). A step whose time is a year, month or day stands for its
/// beginning.
struct TimeRange {
  std::optional<IsoTime> from;
  std::optional<IsoTime> to;

  bool holds(const IsoTime& time) const;
  /// Whether no time can lie in the range.
  bool is_empty() const;
};

}  // namespace thiessen
