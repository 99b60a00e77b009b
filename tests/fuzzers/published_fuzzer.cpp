#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "base/utf8.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/memory_file.h"
#include "fuzzers/message_laws.h"
#include "readings/published/arcswat_files.h"
#include "readings/published/headerless_formats.h"
#include "readings/published/hourly_order.h"
#include "readings/published/month_rows.h"
#include "readings/published/published_format.h"
#include "readings/published/published_formats.h"
#include "readings/published/published_table.h"
#include "readings/published/swat_files.h"
#include "readings/published/text_beginning.h"
#include "readings/published/usgs_rdb.h"
#include "readings/readings_reader.h"
#include "text/csv_reader.h"
#include "text/table.h"

namespace thiessen::fuzzers {
namespace {

using Rows = std::vector<std::vector<std::string>>;

InputFile open_plain(const std::string& file) {
  return InputFile(file);
}

/// Opens a table of the columns of a format, whose files may have none of a header.
std::unique_ptr<Table> open_columns(const std::string& file, const PublishedFormat& format,
                                    bool has_header, const CsvDialect& dialect) {
  CsvOptions options;
  options.finds_form = true;
  options.separator = '\0';
  options.encoding = dialect.encoding;
  options.repeated = dialect.repeated;
  if (!has_header) {
    options.separator = ',';
    for (const std::string_view name : parted(format.columns, ','))
      options.names.emplace_back(name);
  }
  return std::make_unique<CsvReader>(file, options);
}

/// A table of a format, for which its options are made, too.
std::unique_ptr<Table> published(std::unique_ptr<Table> table, const PublishedFormat& format,
                                 Warnings& warnings) {
  const ReadingsOptions said;
  tell_format(format, *table, said, false, warnings);
  if (!format.unit_is_ordered) options_of(format, *table, said);
  return std::make_unique<PublishedTable>(std::move(table), format, said, warnings);
}

/// The same of a text that is known by its beginning.
std::unique_ptr<Table> known_table(const std::string& file, std::string_view text,
                                   Warnings& warnings) {
  if (const PublishedFormat* format = format_of_rows(text))
    return published(open_columns(file, *format, false, {}), *format, warnings);
  const TextBeginning told = look_at_beginning(text, {});
  require(!find_invalid_utf8(told.text) || told.text == text, "a beginning that is no text");
  auto csv = open_columns(file, {}, true, told.dialect);
  if (is_hourly_order_header(csv->header())) return std::make_unique<HourlyOrder>(std::move(csv));
  if (is_ana_header(csv->header())) return std::make_unique<MonthRows>(std::move(csv));
  const PublishedFormat* format = format_of_header(csv->header(), told.text);
  if (format == nullptr) return csv;
  for (const std::string& id : stations_told(*format, told.text, file))
    require(!id.empty(), "a station without a name");
  return published(std::move(csv), *format, warnings);
}

/// The table that a text is known for, or that the byte asks for; null where it is none.
std::unique_ptr<Table> table_of(std::size_t wanted, const std::string& file, std::string_view text,
                                Warnings& warnings) {
  if (wanted == 0)
    return std::make_unique<UsgsRdb>(
        file, [file] { return InputFile(file); }, "", warnings);
  if (wanted <= 2) {
    const SwatFile known = swat_file(text);
    if (known == SwatFile::list) return nullptr;  // which names other files
    const SwatFile asked = wanted == 1 ? SwatFile::gauges : SwatFile::gauge;
    return std::make_unique<SwatRainfall>(file, known == SwatFile::none ? asked : known,
                                          open_plain);
  }
  if (wanted == 3) return std::make_unique<ArcSwatRainfall>(file, ArcSwatFile::gauge, open_plain);
  if (arcswat_file(text) == ArcSwatFile::list) return nullptr;
  return known_table(file, text, warnings);
}

Rows rows_of(Table& table) {
  Rows rows;
  for (Row row; table.next(row);) {
    require(row.fields.size() == table.header().size(), "a row of other fields than the header");
    rows.emplace_back(row.fields.begin(), row.fields.end());
  }
  return rows;
}

}  // namespace

void fuzz_published(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  const std::size_t wanted = bytes.below(8);
  const std::string text(bytes.rest());
  const MemoryFile file(text);
  Warnings warnings;
  const bool is_usgs = is_usgs_rdb(text);
  try {
    const auto table = table_of(is_usgs ? 0 : wanted, file.name(), text, warnings);
    if (!table) return;
    const Rows rows = rows_of(*table);
    const auto again = table->again();
    require(again != nullptr && rows_of(*again) == rows, "other rows when read again");
  } catch (const Error& error) {
    require_placed(error, file.name(), lines_of(text));
  }
  for (const Message& notice : warnings.notices()) require_sentences(Error(notice));
}

}  // namespace thiessen::fuzzers
