#include "files/table_file.h"

#include "files/csv_file.h"
#include "gdal/layers/layer.h"
#include "gdal/layers/opening.h"

namespace thiessen {

std::unique_ptr<Table> open_table(const std::string& file, const CsvDialect& said,
                                  Warnings& warnings) {
  if (file != "-" && read_by_gdal(file)) return std::make_unique<Layer>(file, "", "", &warnings);
  return open_csv(file, said, {}, warnings);
}

}  // namespace thiessen
