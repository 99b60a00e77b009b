#include "files/tables/table_file.h"

#include <string>
#include <utility>
#include <vector>

#include "files/tables/csv_file.h"
#include "files/tables/filtered_table.h"
#include "files/tables/sheet_file.h"
#include "gdal/layers/layer.h"
#include "gdal/layers/opening.h"
#include "text/attributes.h"

namespace thiessen {

namespace {

/// A table, and the types of its fields where it states them.
struct TypedTable {
  std::unique_ptr<Table> table;
  std::vector<FieldType> types;
};

TypedTable open_rows(const Source& source, Warnings& warnings) {
  if (source.file != "-" && read_by_gdal(source.file)) {
    if (auto sheet = open_sheet(source, warnings)) return {std::move(sheet), {}};
    auto layer =
        std::make_unique<Layer>(source.file, source.layer, source.layer_setting, &warnings);
    std::vector<FieldType> types = layer->types();
    return {std::move(layer), std::move(types)};
  }
  if (!source.layer.empty()) throw no_layers(source);
  return {open_csv(source.file, source.csv, {}, warnings), {}};
}

}  // namespace

std::unique_ptr<Table> open_table(const Source& source, Warnings& warnings) {
  TypedTable rows = open_rows(source, warnings);
  if (source.where.empty()) return std::move(rows.table);
  return keep_rows(std::move(rows.table), {source.where, source.where_setting},
                   std::move(rows.types), warnings);
}

}  // namespace thiessen
