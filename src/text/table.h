#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// One record of a table: its fields as text, and where it stands.
struct Row {
  std::size_t line = 0;  ///< the line on which it begins (CSV), or the feature's number, from 1
  std::vector<std::string_view> fields;  ///< as many as the header has; valid until the next row
  bool padded = false;  ///< number_padding bytes can be read where each field begins (number.h)
};

/// A table of text fields, read a row at a time in memory that does not grow with its length:
/// a CSV file, or a layer of anything that GDAL reads.
class Table {
 public:
  virtual ~Table() = default;
  /// The file as the user named it, for messages.
  virtual const std::string& file() const = 0;
  virtual const std::vector<std::string>& header() const = 0;
  /// The line on which the header stands, from 1; 0 where there is none.
  virtual std::size_t header_line() const { return 0; }
  /// Fills `row`; false at the end. A row with too few or too many fields, or that cannot be read,
  /// is gathered; all of them are thrown as one Error at the end.
  virtual bool next(Row& row) = 0;
  /// How much is read, from 0 to 1; NaN where the length is not known.
  virtual double share_read() const { return std::numeric_limits<double>::quiet_NaN(); }
  /// The same table, opened once more at its beginning; nothing where it can only be read once (a
  /// pipe), or is not sure to give its rows in the same order (a database).
  virtual std::unique_ptr<Table> again() const { return nullptr; }
};

}  // namespace thiessen
