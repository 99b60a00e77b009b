#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/wording.h"
#include "readings/times/time_columns.h"

namespace thiessen {

/// The columns of a table among which those of its time are looked for by their names.
struct TimeCandidates {
  std::vector<std::string> header;
  /// Its texts; none where it cannot be seen beforehand. Asked for only where names want it.
  std::function<std::vector<std::string>()> first_row;
  std::function<bool(std::size_t)> may_be_of_time;
};

/// The columns of a time that stands in several and can be read in one way only: year, month and
/// day, or year and day of the year, and behind either hour, minute and second, or a clock; or year
/// and month, where nothing is called as a part of a month. Nothing where there are none, or where
/// the first row has other texts in them than such parts of a time.
std::optional<TimeColumns> time_in_parts(const TimeCandidates& candidates);

/// The settings by which a user says that the time stands in several columns, where it seems to,
/// with the format of the first row's where it needs one. Empty where nothing beside the column
/// `taken`, which is taken for the time, is called as a part of a time that it lacks, or holds a
/// date where that holds none.
Wording time_fields_meant(const TimeCandidates& candidates, std::optional<std::size_t> taken);

}  // namespace thiessen
