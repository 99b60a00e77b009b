#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "text/table.h"

namespace thiessen {

/// The columns of a table in which a time stands, and what each of them holds of it.
class TimeColumns {
 public:
  enum class Part {
    text,
    year,
    month,
    day,
    day_of_year,
    hour,
    hour_minute,  ///< one number: 100 is 01:00
    minute,
    second
  };
  struct Column {
    std::size_t field = 0;
    Part part = Part::text;
  };

  /// One column, whose text is the time.
  // NOLINTNEXTLINE(google-explicit-constructor): a column is columns
  TimeColumns(std::size_t field = 0) : columns_{{field, Part::text}} {}
  /// Requires a column.
  explicit TimeColumns(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// What a column of this name holds.
  static Part part_called(std::string_view name);

  bool has(std::size_t field) const;
  /// Whether each of several holds a part of a time, and none a text.
  bool are_parts() const;
  const std::vector<Column>& columns() const { return columns_; }
  /// The time of a row, as it is written. Of several columns, without the blanks round them: year,
  /// month (a number, or its English name) and day, or year and day of the year, are put together
  /// as 2010-12-31, an hour, a minute and a second follow as 06:00:30, an hour with its minute as
  /// 0600, and all else stands in its order with blanks between. Where a row says both and the day
  /// of the year is another day, the text is none of a time. Valid until the next call or the next
  /// row.
  std::string_view text(const Row& row);

 private:
  std::string_view joined(const Row& row);

  std::vector<Column> columns_;
  std::string text_;
};

}  // namespace thiessen
