#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "gdal/layers/sheet_rows.h"
#include "gdal/layers/xml_reader.h"

namespace thiessen {

/// The names of the sheets of a .ods file, whose content.xml is given as GDAL is given it. Throws
/// Error where it is not whole.
std::vector<std::string> ods_sheets(const std::string& file, const std::string& document);

/// The rows of a sheet of a .ods file (OpenDocument 1.3, part 3, chapter 9). A row or a cell that
/// is written once and repeated comes as often as that. Remarks on cells are no part of them.
class OdsRows : public SheetRows {
 public:
  /// `sheet` counts from 0. Throws Error where the document cannot be opened.
  OdsRows(const std::string& file, const std::string& document, std::size_t sheet);
  ~OdsRows() override;

  const SheetRow* next() override;
  const std::deque<SheetRow>& ahead() override;

 private:
  class Listener;
  void read_ahead();

  std::unique_ptr<Listener> listener_;
  std::unique_ptr<XmlReader> reader_;
  SheetRow row_;
};

}  // namespace thiessen
