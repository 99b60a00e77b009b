#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/patience.h"
#include "base/utf8.h"
#include "text/csv_form.h"
#include "text/csv_text.h"
#include "text/table.h"

namespace thiessen {

/// The limits of a CSV that is read. A larger one is an Error that names the limit.
struct CsvLimits {
  std::size_t field_bytes = std::size_t{1} << 20;  ///< 1 MiB: raise it for a column of geometries
  std::size_t row_bytes = std::size_t{64} << 20;   ///< 64 MiB
  std::size_t columns = 500'000;
};

/// How a CSV file is read.
struct CsvOptions {
  /// What parts the fields: one ASCII character, neither a quote nor a line end; '\0': it is found
  /// out, see find_csv_form. Where it is a blank, several of them are one, and those at a line's
  /// ends part nothing.
  char separator = ',';
  CsvLimits limits = {};
  bool has_names = true;  ///< false: the first row may be data; its fields are not checked as names
  std::string encoding = {};  ///< of the text, see Decoder; empty: UTF-8, or UTF-16 with its mark
  /// Whether the file's first 64 kB, from a pipe its first row of data, tell how it is written: see
  /// find_csv_form. Then blanks round a field outside quotes are no part of it, where the beginning
  /// has some, rows without any value are passed over, and so are columns at the end that have
  /// neither a name nor a value, and empty fields behind the last column.
  bool finds_form = false;
  std::optional<std::size_t> skip = {};   ///< lines before the header; nothing: they are found out
  bool skip_is_of_all = false;            ///< see CsvDialect
  bool decimal_comma = false;             ///< false: the decimal mark is found out
  std::vector<std::string> numbers = {};  ///< see CsvDialect
  std::vector<std::string> names = {};
  std::vector<std::string> repeated = {};
  std::string input = {};
};

/// A reader of CSV files, which reads one row at a time (RFC 4180).
///
/// Lines end in LF, CRLF or CR; the last line need not end. One byte order mark at the beginning is
/// skipped, and so are lines that are empty or blank. A field that begins with a quote must end
/// with one, and may contain separators, line ends and doubled quotes. Header names outside quotes
/// lose the blanks at their ends. Names must all be different; a column without a name is legal.
/// Lines are numbered from 1, as an editor numbers them.
///
/// A pipe may go on for ever: see is_waiting. Where a row of it has a fault, none of those that
/// follow is a row; the error is thrown once nothing more comes for a while (see Patience).
///
/// Errors that are gathered and thrown at the end: rows with too few or too many fields, a quote
/// inside a field, text after a closing quote, a value in a column that was passed over. Errors
/// that are thrown at once: a NUL byte, bytes that are not of the encoding (with their offset from
/// 0), a quote that is never closed, anything beyond the limits, an empty file, a header name that
/// stands twice, a header of one name that contains another separator.
///
/// Memory: a buffer of at most twice the longest row. Speed: about 500 MB a second and core where
/// fields are numbers of 1 to 4 digits, none in quotes.
class CsvReader : public Table {
 public:
  /// Opens the file (`-` is the standard input) and reads the header. Throws Error.
  explicit CsvReader(const std::string& file, CsvOptions options = {});
  /// Reads a file that is open. It cannot be read again.
  explicit CsvReader(InputFile input, CsvOptions options = {});

  const std::string& file() const override { return text_.name(); }
  const std::vector<std::string>& header() const override { return header_; }
  std::size_t header_line() const override { return header_line_; }
  DecimalMark decimal_mark() const override { return form_.mark; }
  std::string unit(std::size_t field) const override {
    return field < form_.column_units.size() ? form_.column_units[field] : std::string();
  }
  std::vector<std::string> lines_above() const override { return form_.lines_above; }
  bool next(Row& row) override;
  /// A line that has come in part is waited for, but not what follows a line end in quotes, nor
  /// rows of more than 1 MiB.
  bool is_waiting(std::chrono::milliseconds patience) override;
  double share_read() const override;
  std::unique_ptr<Table> again() const override;
  std::unique_ptr<Table> first_rows() const override;
  std::vector<std::string> row_seen() const override { return row_seen_; }
  /// The byte of the file at which the row that was read last begins. Requires a file that is no
  /// pipe.
  std::size_t row_offset() const { return row_; }
  /// What parts the fields, be it given or found out.
  char separator() const { return options_.separator; }
  /// What the beginning told; what was asked for says CsvOptions.
  const CsvForm& form() const { return form_; }
  /// The encoding of the file; empty for UTF-8.
  std::string encoding() const { return text_.encoding(); }
  /// Throws Error where the header has a name twice, or seems to use another separator. The
  /// constructor calls it where the options say that there are names.
  void check_header() const;

 private:
  enum class RowKind : std::uint8_t { whole, bad, none };
  enum class Reached : std::uint8_t { row, no_row, end };
  enum class Follows : std::uint8_t { separator, line_end, nothing, text };

  CsvReader(InputFile input, CsvOptions options, bool is_on_disk);
  void skip_byte_order_mark();
  void find_form();
  void look_at_beginning(std::size_t begin);
  void keep_row_seen(std::size_t begin);
  void read_header();
  void pass_columns();
  void number_columns();
  void take_first_row(std::vector<std::string> names);
  bool next_of_first(Row& row);
  void pass_rows_below_header();
  bool is_row(const Row& row);
  Reached read_next(Row& row);
  bool waits(std::chrono::milliseconds patience);
  bool has_line();
  void look_for_more();
  void pass_line_feed();

  RowKind read_row(std::vector<std::string_view>& fields);
  void store(std::string_view field, bool in_quotes) {
    if (trims_ && !in_quotes && !field.empty() &&
        (is_blank(field.front()) || is_blank(field.back())))
      field = trimmed(field);
    if (field_count_ < fields_->size()) {
      (*fields_)[field_count_++] = field;
    } else {
      store_beyond(field, in_quotes);
    }
  }
  void store_beyond(std::string_view field, bool in_quotes);
  RowKind end_row(std::size_t at);
  RowKind end_last_row();
  RowKind skip_rest_of_line(std::size_t from, const std::string& fault, std::size_t column);
  bool is_blank_line(std::size_t end) const;
  bool is_after_blank(std::size_t end) const;
  void begin_row(std::size_t at);

  Follows read_quoted_field();
  std::size_t find_closing_quote(std::size_t& doubled);

  bool read_more(bool in_quotes = false);
  void keep_views(std::uintptr_t before);
  void check_limits(bool in_quotes);
  void check_lengths(std::size_t end);
  void refuse_bytes(CsvText::Arrival arrival);
  [[noreturn]] void fail(std::size_t line, std::string text, Wording hint = {});

  static bool is_blank(char c) { return c == ' ' || c == '\t'; }

  CsvOptions options_;
  CsvOptions said_;  ///< the options before anything was found out
  CsvForm form_;
  std::string beginning_;               ///< what told the form, where it can be read only once
  std::vector<std::string> row_seen_;   ///< the first row of a pipe that is still read
  std::vector<std::string> first_row_;  ///< that of a table without a header
  bool has_first_row_ = false;
  bool trims_ = false;  ///< whether fields lose the blanks at their ends
  bool is_on_disk_;     ///< it has a name by which it can be opened again
  CsvText text_;
  std::vector<std::string> header_;
  std::size_t header_line_ = 0;
  Complaints complaints_;

  std::size_t row_ = 0;    ///< the offset at which the row begins
  std::size_t field_ = 0;  ///< the offset at which the field begins
  std::size_t next_row_ = 0;
  std::size_t line_ = 1;  ///< the line now being read; within quotes, the one on which they open
  std::size_t row_line_ = 1;
  /// How many fields the row has so far. Any beyond the header's are counted, but not kept.
  std::size_t field_count_ = 0;
  std::vector<std::string_view>* fields_ = nullptr;
  std::size_t beyond_ = 0;  ///< the first field beyond the header's that has a value; 0: none

  // Of a pipe.
  Row ahead_;  ///< the next row, where it was read to see whether it has come
  bool has_ahead_ = false;
  bool after_return_ = false;    ///< the last row ended in CR, and its LF may be still to come
  std::size_t blank_to_ = 0;     ///< the lines from the next row to here are blank
  std::size_t searched_to_ = 0;  ///< the line from there has no end before this
  Patience patience_;            ///< with what may follow a row that has a fault
};

}  // namespace thiessen
