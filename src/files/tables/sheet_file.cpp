#include "files/tables/sheet_file.h"

#include <string_view>

#include "gdal/layers/opening.h"
#include "gdal/layers/xlsx_table.h"

namespace thiessen {

std::unique_ptr<Table> open_sheet(const Source& source, Warnings& warnings) {
  if (source.file == "-" || !read_by_gdal(source.file)) return nullptr;
  const Opening opening = find_opening(source.file);
  if (opening.drivers.front() != std::string_view("XLSX")) return nullptr;
  return std::make_unique<XlsxTable>(XlsxTable::Request{source.file, opening.name, source.layer,
                                                        source.layer_setting, source.csv.skip},
                                     &warnings);
}

}  // namespace thiessen
