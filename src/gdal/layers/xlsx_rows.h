#pragma once

#include <deque>
#include <memory>
#include <string>

#include "gdal/layers/sheet_rows.h"
#include "gdal/layers/xlsx_book.h"
#include "gdal/layers/xml_reader.h"

namespace thiessen {

/// The rows of a sheet of a .xlsx file.
class XlsxRows : public SheetRows {
 public:
  /// The book must outlive this object. Throws Error where the sheet cannot be opened.
  XlsxRows(const std::string& file, const XlsxBook& book, const XlsxBook::Sheet& sheet);
  ~XlsxRows() override;

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
