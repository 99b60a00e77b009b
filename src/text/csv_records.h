#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/wording.h"

namespace thiessen {

/// A record in the beginning of a CSV: a line, or several where quotes hold line ends.
struct CsvRecord {
  std::string_view text;
  std::size_t at = 0;  ///< where it begins
  bool whole = true;   ///< false: the beginning ends within it
};

/// The records of the beginning of a CSV from a place on, without blank lines. Quotes that do not
/// close before its end, as in a title, hold no line ends. `is_all`: the beginning is the whole
/// file, whose last line need not end.
std::vector<CsvRecord> csv_records(std::string_view beginning, std::size_t from, bool is_all);

/// The fields of a record, without their quotes and the blanks round them. Where the separator is a
/// blank, several of them are one. A record that is not whole loses its last field.
std::vector<std::string_view> csv_fields(const CsvRecord& record, char separator);

/// Whether a number's comma may be its decimal mark as well as part its thousands: 1,234.
bool may_part_thousands(std::string_view number);

/// Why a text that has a decimal comma is no number where points are read: ` is no number`, or the
/// two numbers that it may be.
std::string no_number_for_its_comma(std::string_view text);

/// What may be done about such a text in the file that the user calls so (stations, rainfall).
Wording hint_for_its_comma(std::string_view text, std::string_view input);

/// What may be done about a number with a point where decimal commas are read, as the user says or
/// as was found out.
Wording hint_for_its_point(std::string_view input, bool commas_are_said);

/// The setting of how one file is written, which is called as `input` (`rainfall_encoding`), or of
/// all files where that is empty.
std::string setting_for(std::string_view input, std::string_view name);

}  // namespace thiessen
