#include "gdal/layers/sheet_book.h"

#include <utility>

#include "gdal/layers/ods_rows.h"
#include "gdal/layers/xlsx_book.h"
#include "gdal/layers/xlsx_rows.h"

namespace thiessen {
namespace {

class XlsxSheets : public SheetBook {
 public:
  XlsxSheets(std::string file, const std::string& name)
      : file_(std::move(file)), book_(read_xlsx_book(file_, name)) {
    for (const XlsxBook::Sheet& sheet : book_.sheets)
      sheets_.push_back({sheet.name, sheet.is_hidden});
  }

  const std::vector<Sheet>& sheets() const override { return sheets_; }
  std::unique_ptr<SheetRows> rows(std::size_t sheet) const override {
    return xlsx_rows(file_, book_, book_.sheets[sheet]);
  }
  bool counts_from_1904() const override { return book_.from_1904; }

 private:
  std::string file_;
  XlsxBook book_;
  std::vector<Sheet> sheets_;
};

class OdsSheets : public SheetBook {
 public:
  OdsSheets(std::string file, const std::string& name)
      : file_(std::move(file)), document_("/vsizip/{" + name + "}/content.xml") {
    for (std::string& sheet : ods_sheets(file_, document_)) sheets_.push_back({std::move(sheet)});
  }

  const std::vector<Sheet>& sheets() const override { return sheets_; }
  std::unique_ptr<SheetRows> rows(std::size_t sheet) const override {
    return ods_rows(file_, document_, sheet);
  }

 private:
  std::string file_;
  std::string document_;
  std::vector<Sheet> sheets_;
};

}  // namespace

std::shared_ptr<const SheetBook> open_sheet_book(SheetKind kind, const std::string& file,
                                                 const std::string& name) {
  if (kind == SheetKind::ods) return std::make_shared<OdsSheets>(file, name);
  return std::make_shared<XlsxSheets>(file, name);
}

}  // namespace thiessen
