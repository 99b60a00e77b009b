#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.h"

namespace thiessen {

/// One record of a table: its fields as text, and where it stands.
struct Row {
  /// The line on which it begins (CSV), the feature's number, from 1, or a number that grows from
  /// row to row: see Table::numbers_rows.
  std::size_t line = 0;
  std::vector<std::string_view> fields;  ///< as many as the header has; valid until the next row
  bool padded = false;  ///< number_padding bytes can be read where each field begins (number.h)
};

/// The place of a row, as messages tell it.
struct RowPlace {
  std::string file;
  std::size_t line = 0;    ///< 0 where no line holds it
  std::string words = {};  ///< what tells it then
};

/// A table of text fields that is read one row at a time, in memory that does not grow with its
/// length: a CSV file, or a layer of any kind that GDAL reads.
class Table {
 public:
  virtual ~Table() = default;
  /// The name of the file as the user gave it, for messages.
  virtual const std::string& file() const = 0;
  virtual const std::vector<std::string>& header() const = 0;
  /// How many of the columns, the first ones, stand in the file.
  virtual std::size_t columns_in_file() const { return header().size(); }
  /// How numbers are written in it, as far as that is known of its texts.
  virtual DecimalMark decimal_mark() const { return DecimalMark::point; }
  /// What a row of units below the header says of a column; empty where there is none.
  virtual std::string unit(std::size_t /*field*/) const { return {}; }
  /// What stands above the header, a text a line, as far as it is kept: titles, remarks.
  virtual std::vector<std::string> lines_above() const { return {}; }
  /// The line on which the header stands, from 1; 0 where there is none.
  virtual std::size_t header_line() const { return 0; }
  /// Whether a row's number is none of a line, for several rows stand in one, or they stand in
  /// several files.
  virtual bool numbers_rows() const { return false; }
  /// The place of a row that has been read, by its number.
  virtual RowPlace place(std::size_t number) const { return {file(), number, {}}; }
  /// Reads the next row into `row`; returns false at the end. A row that has too few or too many
  /// fields or cannot be read is gathered as a fault; all faults are thrown as one Error at the
  /// end.
  virtual bool next(Row& row) = 0;
  /// Whether the next row, or the end, has not come yet, nor comes within `patience`: then `next`
  /// would wait for it. Only of what is read from a pipe is it ever true. The fields of the row
  /// before are no longer valid.
  virtual bool is_waiting(std::chrono::milliseconds /*patience*/) { return false; }
  /// The share of the table that is read so far, from 0 to 1; NaN where the length is not known.
  virtual double share_read() const { return std::numeric_limits<double>::quiet_NaN(); }
  /// Opens the same table once more at its beginning. Returns null where it can be read only once
  /// (a pipe), or might not give its rows in the same order (a database).
  virtual std::unique_ptr<Table> again() const { return nullptr; }
  /// The texts of the first row, where it was seen before it is read and cannot be read again: of a
  /// pipe that brings one row at a time.
  virtual std::vector<std::string> row_seen() const { return {}; }
  /// Opens the rows at the beginning once more, or all; null where they have gone.
  virtual std::unique_ptr<Table> first_rows() const { return again(); }
};

}  // namespace thiessen
