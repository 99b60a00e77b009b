#include "files/table_file.h"

#include "gdal/layers/layer.h"
#include "gdal/layers/opening.h"
#include "text/csv_reader.h"

namespace thiessen {

std::unique_ptr<Table> open_table(const std::string& file, char separator) {
  if (file != "-" && read_by_gdal(file)) return std::make_unique<Layer>(file, "", "");
  CsvOptions options;
  if (separator != '\0') options.separator = separator;
  return std::make_unique<CsvReader>(file, options);
}

}  // namespace thiessen
