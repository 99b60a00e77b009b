#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"

namespace thiessen {

/// The calendar month, from 0, in which the rain of a step fell; nothing where its time tells none.
std::optional<std::size_t> month_of(std::string_view time,
                                    const std::optional<WrittenTime>& written, Stamp stamp);

/// The calendar year in which it fell; nothing where its time tells none.
std::optional<int> year_of(std::string_view time, const std::optional<WrittenTime>& written,
                           Stamp stamp);

/// Tells in which calendar month the rain of a step fell, as its time is written: of times that end
/// their steps midnight of the first of a month belongs to the month before.
class StepMonths {
 public:
  /// `file` is for messages.
  StepMonths(std::string file, Stamp stamp) : file_(std::move(file)), stamp_(stamp) {}

  /// The month from 0. Throws Error where the time tells none.
  std::size_t of(std::string_view time, const std::optional<WrittenTime>& written,
                 std::size_t line) const;

 private:
  std::string file_;
  Stamp stamp_;
};

}  // namespace thiessen
