#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "gdal/layers/xlsx_book.h"
#include "gdal/layers/xml_reader.h"

namespace thiessen {

/// A cell: a text, or the serial number of a time.
struct XlsxCell {
  std::string text;
  bool is_time = false;
  double serial = 0;
  CellForm form;
};

/// A row of a sheet, from its column A on, without empty cells at its end.
struct XlsxRow {
  std::size_t number = 0;  ///< as the sheet has it, from 1
  std::vector<XlsxCell> cells;
};

/// The rows of a sheet of a .xlsx file that are not empty, one at a time.
///
/// Numbers come in the shortest digits that read back to them, whatever their cell's form, and
/// logical values as 1 and 0; `#N/A` is an empty cell, and another error its text, as is `=` of a
/// formula whose value the file lacks.
class XlsxRows {
 public:
  /// The book must outlive this object. Throws Error where the sheet cannot be opened.
  XlsxRows(const std::string& file, const XlsxBook& book, const XlsxBook::Sheet& sheet);
  ~XlsxRows();

  /// The next row; null at the end. Throws Error.
  const XlsxRow* next();
  /// The rows that are read ahead, of which there are some 64 kB of the document, from the next on.
  const std::deque<XlsxRow>& ahead();

 private:
  class Listener;
  void read_ahead();

  std::unique_ptr<Listener> listener_;
  std::unique_ptr<XmlReader> reader_;
  XlsxRow row_;
};

}  // namespace thiessen
