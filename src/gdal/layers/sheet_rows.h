#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gdal/layers/cell_form.h"
#include "gdal/layers/xml_reader.h"

namespace thiessen {

/// A cell: a text, or the serial number of a time.
struct SheetCell {
  std::string text;
  bool is_time = false;
  double serial = 0;
  CellForm form;

  bool is_empty() const { return text.empty() && !is_time; }
};

/// A row of a sheet, from its first column on, without empty cells at its end.
struct SheetRow {
  std::size_t number = 0;  ///< as the sheet has it, from 1
  std::vector<SheetCell> cells;
  std::size_t times = 1;  ///< how often it comes, each time with the next number
};

/// Hears a sheet's document, and puts its rows that are not empty behind each other. Numbers come
/// in the shortest digits that read back to them, whatever their cell's form, and logical values as
/// 1 and 0; `#N/A` is an empty cell, and another error its text, as is `=` of a formula whose value
/// the file lacks.
class SheetListener : public XmlListener {
 public:
  std::deque<SheetRow> rows;
};

/// The rows of a sheet that are not empty, one at a time.
class SheetRows {
 public:
  /// `document` is the sheet's as GDAL is given it, `file` as messages name it. Throws Error where
  /// it cannot be opened.
  SheetRows(const std::string& file, const std::string& document,
            std::unique_ptr<SheetListener> listener)
      : listener_(std::move(listener)), reader_(file, document, *listener_) {}

  /// The next row; null at the end. Throws Error.
  const SheetRow* next();
  /// The rows that are read ahead, of which there are some 64 kB of the document, from the next on.
  const std::deque<SheetRow>& ahead();

 private:
  std::unique_ptr<SheetListener> listener_;
  XmlReader reader_;
  SheetRow row_;
};

}  // namespace thiessen
