#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "gdal/layers/cell_form.h"

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

/// The rows of a sheet that are not empty, one at a time.
///
/// Numbers come in the shortest digits that read back to them, whatever their cell's form, and
/// logical values as 1 and 0; `#N/A` is an empty cell, and another error its text, as is `=` of a
/// formula whose value the file lacks.
class SheetRows {
 public:
  virtual ~SheetRows() = default;

  /// The next row; null at the end. Throws Error.
  virtual const SheetRow* next() = 0;
  /// The rows that are read ahead, of which there are some 64 kB of the document, from the next on.
  virtual const std::deque<SheetRow>& ahead() = 0;
};

}  // namespace thiessen
