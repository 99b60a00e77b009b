#include "files/tables/sheet_file.h"

#include <string_view>

#include "gdal/layers/opening.h"
#include "gdal/layers/sheet_table.h"

namespace thiessen {

std::unique_ptr<Table> open_sheet(const Source& source, Warnings& warnings) {
  if (source.file == "-" || !read_by_gdal(source.file)) return nullptr;
  const Opening opening = find_opening(source.file);
  const std::string_view driver = opening.drivers.front();
  if (driver != "XLSX" && driver != "ODS") return nullptr;
  return std::make_unique<SheetTable>(
      SheetTable::Request{source.file, opening.name, source.layer, source.layer_setting,
                          source.csv.skip, driver == "ODS" ? SheetKind::ods : SheetKind::xlsx},
      &warnings);
}

}  // namespace thiessen
