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
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/memory_file.h"
#include "fuzzers/message_laws.h"
#include "readings/published/month_rows.h"
#include "readings/published/published_format.h"
#include "readings/published/published_table.h"
#include "readings/published/swat_files.h"
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

/// The table that a text is known for, or that the byte asks for; null where it is none.
std::unique_ptr<Table> table_of(std::size_t wanted, const std::string& file, std::string_view text,
                                Warnings& warnings) {
  if (wanted == 0) return std::make_unique<UsgsRdb>(file, [file] { return InputFile(file); });
  if (wanted <= 2) {
    const SwatFile known = swat_file(text);
    if (known == SwatFile::list) return nullptr;  // which names other files
    const SwatFile asked = wanted == 1 ? SwatFile::gauges : SwatFile::gauge;
    return std::make_unique<SwatRainfall>(file, known == SwatFile::none ? asked : known,
                                          open_plain);
  }
  CsvOptions options;
  options.finds_form = true;
  options.separator = '\0';
  auto csv = std::make_unique<CsvReader>(file, options);
  if (is_ana_header(csv->header())) return std::make_unique<MonthRows>(std::move(csv));
  const PublishedFormat* format = format_of_header(csv->header());
  if (format == nullptr) return csv;
  const ReadingsOptions said;
  if (!format->unit_is_ordered) options_of(*format, *csv, said);
  return std::make_unique<PublishedTable>(std::move(csv), *format, said, warnings);
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
  const std::size_t wanted = bytes.below(6);
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
