#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/iso_time.h"

namespace thiessen {

/// A form in which times are written, told as strptime and the C++ library tell it: %d/%m/%Y %H:%M.
/// Names of months are English. `excel` are the serial numbers of spreadsheets: days since the
/// beginning of 1900, whose 29 February these take for a day.
///
/// A time read so has the precision of the format: a clock, a day, a month or a year. 24:00 is the
/// end of the day. Years have four digits. Not safe for several threads at once. Cost: about a
/// microsecond a time.
class TimeFormat {
 public:
  static constexpr std::string_view excel = "excel";

  /// Requires is_sound.
  explicit TimeFormat(std::string format);
  ~TimeFormat();
  TimeFormat(TimeFormat&&) noexcept;
  TimeFormat& operator=(TimeFormat&&) noexcept;

  /// Whether this is `excel`, or a format that says a year and, as far as it says more, the month
  /// of a day and the day of a clock.
  static bool is_sound(const std::string& format);

  const std::string& text() const { return format_; }
  bool is_excel() const { return format_ == excel; }
  /// Reads the whole text.
  ParsedTime read(std::string_view text) const;

 private:
  struct Stream;

  ParsedTime read_serial(std::string_view text) const;
  int day_of_year_in(const std::string& text) const;

  std::string format_;
  bool has_day_of_year_ = false;
  std::string before_day_of_year_;  ///< the format up to its %j
  std::string whole_format_;        ///< with the month and the day that it lacks
  std::string rest_;                ///< what a text lacks of these
  TimePrecision precision_ = TimePrecision::year;
  std::unique_ptr<Stream> stream_;
};

}  // namespace thiessen
