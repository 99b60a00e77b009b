#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
///
/// What is nearly a time, such as one with a year of two digits, is a label, the first of which
/// tells the formats that would read it.
///
/// Times may be mere labels (storm 1). Not so where the table begins with two times of the calendar
/// and most of its first ones are such: a text that is none is then a fault of the file, such as
/// Total below the last row. Where nothing but the first time was seen beforehand, three times of
/// the calendar before the first label tell the same.
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

  /// Whether a text is no time in a table whose times are none but those of the calendar.
  bool is_no_time(std::string_view text, std::size_t line);

  /// Whether no time may be a mere label.
  bool has_format() const { return given_.has_value(); }
  /// Says that times are put together from parts of the calendar, so that none is a mere label.
  void times_are_of_parts() { are_of_parts_ = true; }
  /// Says what the column of times is called, for messages; empty where they stand in several.
  void times_stand_in(std::string column) { column_ = std::move(column); }
  /// The time that told whether the day or the month comes first, and its line, where times before
  /// it had left that open; an empty text otherwise.
  struct OrderTold {
    std::string by;
    std::size_t line = 0;
    bool is_day_first = false;
  };
  OrderTold order_told() const;

 private:
  enum class Order { unknown, day_first, month_first };
  /// The formats of the time before, which are tried first.
  struct Formats {
    TimeFormat one;
    std::optional<TimeFormat> month_first;
  };

  /// What is known of whether times are labels.
  struct Seen {
    std::size_t times = 0;  ///< of the calendar
    std::size_t labels = 0;
    bool begins_with_times = true;  ///< none of the first two is a label
  };

  std::optional<WrittenTime> read_written(std::string_view text, std::size_t line);
  static void note(bool is_time, Seen& seen);
  bool may_be_labels() const;
  WrittenTime no_time(std::string_view text) const;
  std::optional<WrittenTime> left_open(std::string_view text);
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
  bool is_left_open_ = false;  ///< whether a time that was seen leaves the order open
  bool told_late_ = false;     ///< whether times before that one had left the order open
  Seen before_;                ///< of the times that the table begins with
  Seen since_;                 ///< of those that were read
  bool are_of_parts_ = false;
  bool told_open_ = false;  ///< whether it was told what formats would read a text
  std::string column_;
  std::vector<Formats> formats_;
};

}  // namespace thiessen
