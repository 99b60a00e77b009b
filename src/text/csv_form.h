#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.h"

namespace thiessen {

/// How many bytes of a file tell how it is written.
constexpr std::size_t csv_beginning_bytes = std::size_t{64} << 10;

/// What is known of a CSV before its beginning is looked at.
struct CsvHints {
  char separator = '\0';            ///< '\0': it is to be found out
  bool decimal_comma = false;       ///< false: it is to be found out
  std::optional<std::size_t> skip;  ///< lines before the header; nothing: to be found out
  bool has_names = true;            ///< false: the first row is data
  bool is_all = true;               ///< the beginning is all of the file
  bool one_row = false;             ///< no row behind the first one may tell anything
};

/// What the beginning of a CSV tells of how it is written.
struct CsvForm {
  char separator = ',';
  DecimalMark mark = DecimalMark::point;
  std::size_t header = 0;    ///< where the header begins
  std::size_t preamble = 0;  ///< lines before the header that are no remarks, passed over
  std::vector<std::string> lines_above;   ///< the last hundred lines before the header, remarks too
  std::size_t rows_passed = 0;            ///< rows below the header that hold units or formats
  std::string units;                      ///< the units in one of these, each once: "mm, degC"
  std::vector<std::string> column_units;  ///< the same by column; empty where none stands
  std::size_t columns_passed = 0;         ///< columns at the end without a name and without a value
  bool has_blanks = false;                ///< blanks stand where a field begins or ends
  bool has_rows = false;                  ///< a whole row stands below the header
};

/// Finds out how a CSV is written from its beginning, in UTF-8 and behind its byte order mark.
///
/// The separator is that of comma, semicolon, tab and bar that stands most often in the header, of
/// those that part the row below into as many fields if there is one; a line `sep=;` before the
/// header says it. Blanks part the fields where none of the others stands in a header that has a
/// known name, and all rows have as many words.
///
/// Decimal marks are commas where a field is a number with one that cannot part thousands, and none
/// is a number with a point. Lines before the header that begin with # are passed over, unless the
/// last of them has the names of a row of data below; and lines before the first that has a known
/// name and the fields of the rows below it, where the first line of all has neither, or has fewer
/// fields.
CsvForm find_csv_form(std::string_view beginning, const CsvHints& hints);

}  // namespace thiessen
