#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rainfall/series/readings.h"
#include "readings/times/time_format.h"

namespace thiessen {

/// Reads the times of one table that are not written as ISO 8601 wants it.
///
/// Where the user gives a format, all times are written so. Else times that can be read in one way
/// only are (see time_shape). Whether the day or the month comes first is told by the first time
/// that leaves no choice (13/1/2010), of those that the table begins with; where none of them does,
/// a time such as 1/2/2010 is ambiguous, and its fault shows both readings. A time that contradicts
/// what was found, or the user's format, is a fault of the file.
class TimeReader {
 public:
  /// An empty format: none is given. `day_first`: the day of dates comes before their month, as the
  /// publisher of the table says. Throws Error where the format is not sound.
  explicit TimeReader(const std::string& format = {}, bool day_first = false);

  /// Takes a time of those that the table begins with; `line` is for messages.
  void see(std::string_view text, std::size_t line);
  /// What the time says, where it is not written as ISO 8601 wants it or a format is given; nothing
  /// where it is to be read as ISO 8601.
  std::optional<WrittenTime> read(std::string_view text, std::size_t line);

  /// Whether no time may be a mere label.
  bool has_format() const { return given_.has_value(); }

 private:
  enum class Order { unknown, day_first, month_first };
  /// The formats of the time before, which are tried first.
  struct Formats {
    TimeFormat one;
    std::optional<TimeFormat> month_first;
  };

  WrittenTime read_given(std::string_view text) const;
  WrittenTime read_ordered(std::string_view text, std::size_t line, const ParsedTime& day_first,
                           const ParsedTime& month_first);
  WrittenTime contradiction() const;
  static WrittenTime ambiguous(const ParsedTime& day_first, const ParsedTime& month_first,
                               const Formats& formats);
  const Formats* formats_of(std::string_view text);

  std::optional<TimeFormat> given_;
  bool serials_have_clocks_ = false;
  Order order_ = Order::unknown;
  bool is_begun_ = false;  ///< a time with two readings came while the order was not known
  std::string told_by_;    ///< the time that told the order, and its line; empty: the publisher
  std::size_t told_in_ = 0;
  std::vector<Formats> formats_;
};

}  // namespace thiessen
