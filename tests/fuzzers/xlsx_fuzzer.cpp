#include <cpl_vsi.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/message_laws.h"
#include "gdal/drivers.h"
#include "gdal/layers/cell_form.h"
#include "gdal/layers/ods_file.h"
#include "gdal/layers/sheet_table.h"
#include "gdal/layers/xlsx_file.h"

namespace thiessen::fuzzers {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// The rows of a table. Requires that they have the header's fields, and numbers that grow from
/// that of the header on.
Rows rows_of(Table& table) {
  Rows rows;
  std::size_t last = table.header_line();
  for (Row row; table.next(row); last = row.line) {
    require(row.fields.size() == table.header().size(), "a row of other fields than the header");
    require(row.line > last, "rows out of the sheet's order");
    rows.emplace_back(row.fields.begin(), row.fields.end());
  }
  return rows;
}

void read_sheet(Bytes& bytes) {
  std::optional<std::size_t> skip;
  if (bytes.below(4) == 0) skip = bytes.below(4);
  const SheetKind kind = bytes.below(2) == 0 ? SheetKind::xlsx : SheetKind::ods;
  const char* const path = kind == SheetKind::ods ? "/vsimem/fuzzed.ods" : "/vsimem/fuzzed.xlsx";
  const std::string workbook(bytes.until('\xFE'));
  if (kind == SheetKind::ods) {
    write_ods(path, {{"rain", std::string(bytes.rest())}});
  } else {
    write_xlsx(path, {{"rain", std::string(bytes.rest())}}, workbook);
  }
  Warnings warnings;
  try {
    SheetTable table({path, path, "", "rainfall_layer", skip, kind}, &warnings);
    const Rows rows = rows_of(table);
    const auto again = table.again();
    require(again != nullptr && rows_of(*again) == rows, "other rows when read again");
  } catch (const Error& error) {
    require_placed(error, path, std::numeric_limits<std::size_t>::max());
  }
  for (const Message& notice : warnings.notices()) require_sentences(Error(notice));
  VSIUnlink(path);
}

/// Any code of a cell's form, and the times that a number stands for with it.
void read_form(Bytes& bytes) {
  const double serial = static_cast<double>(bytes.next()) * 300 + bytes.next() / 256.0;
  const bool with_clock = bytes.below(2) == 0;
  const CellForm form = form_of_code(bytes.rest());
  const auto time = time_of_serial(serial, form, with_clock, false);
  if (!time) return;
  const bool shows_clock = time->find(':') != std::string::npos;
  require(shows_clock || !has_clock(serial), "a clock that is lost: " + *time);
}

}  // namespace

void fuzz_xlsx(std::span<const std::uint8_t> input) {
  static const bool started = [] {
    start_gdal();
    return true;
  }();
  require(started, "GDAL");
  Bytes bytes(input);
  if (bytes.below(8) == 0) {
    read_form(bytes);
  } else {
    read_sheet(bytes);
  }
}

}  // namespace thiessen::fuzzers
