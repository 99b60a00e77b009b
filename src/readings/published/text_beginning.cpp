#include "readings/published/text_beginning.h"

#include <algorithm>
#include <filesystem>

#include "base/utf8.h"
#include "readings/published/arcswat_files.h"
#include "readings/published/headerless_formats.h"
#include "readings/published/month_rows.h"
#include "readings/published/published_formats.h"
#include "readings/published/swat_files.h"
#include "readings/published/usgs_rdb.h"
#include "readings/readings_layout.h"
#include "text/csv_form.h"
#include "text/csv_records.h"
#include "text/decoder.h"
#include "text/text_lines.h"

namespace thiessen {
namespace {

/// Whether bytes are UTF-8, but for a character that they end within.
bool is_utf8(std::string_view bytes) {
  constexpr std::size_t longest_character = 4;
  const auto fault = find_invalid_utf8(bytes);
  return !fault ||
         (bytes.size() >= csv_beginning_bytes && *fault + longest_character > bytes.size());
}

std::vector<std::string> header_in(std::string_view text, const CsvDialect& said) {
  const CsvHints hints{said.separator, said.decimal_comma, said.skip, true, false, false};
  const CsvForm form = find_csv_form(text, hints);
  const auto records = csv_records(text, form.header, false);
  if (records.empty()) return {};
  const auto fields = csv_fields(records.front(), form.separator);
  return {fields.begin(), fields.end()};
}

/// The text behind a label up to the end of its line, without the marks that part the two.
std::string text_behind(std::string_view label, std::string_view text) {
  while (!text.empty()) {
    std::string_view line = trimmed(take_line(text));
    if (!equal_ignoring_case(line.substr(0, label.size()), label)) continue;
    line.remove_prefix(label.size());
    const std::size_t begin = std::min(line.find_first_not_of(";: \t"), line.size());
    const std::size_t last = line.find_last_not_of("; \t");
    return begin < line.size() ? std::string(line.substr(begin, last + 1 - begin)) : std::string();
  }
  return {};
}

}  // namespace

TextBeginning look_at_beginning(std::string_view bytes, const CsvDialect& said) {
  TextBeginning told{"", said, false};
  const bool is_known = is_utf8(bytes);
  told.text = is_known ? std::string(bytes) : decoded(bytes, "Latin-1");
  if (is_known && !begins_as_published(told.text)) return told;
  const PublishedFormat* format = format_of_header(header_in(told.text, said), told.text);
  if (format == nullptr) return told;
  if (!format->repeated.empty()) told.dialect.repeated = {std::string(format->repeated)};
  told.tells_encoding = !is_known && said.encoding.empty() && !format->encoding.empty();
  if (told.tells_encoding) told.dialect.encoding = format->encoding;
  return told;
}

bool begins_as_readings(std::string_view bytes) {
  if (is_usgs_rdb(bytes) || swat_file(bytes) != SwatFile::none ||
      arcswat_file(bytes) != ArcSwatFile::none || format_of_rows(bytes) != nullptr)
    return true;
  const std::string text = is_utf8(bytes) ? std::string(bytes) : decoded(bytes, "Latin-1");
  const std::vector<std::string> header = header_in(text, {});
  return is_ana_header(header) || format_of_header(header, text) != nullptr ||
         is_long_header(header);
}

std::vector<std::string> stations_told(const PublishedFormat& format, std::string_view beginning,
                                       const std::string& file) {
  std::vector<std::string> told;
  if (!format.label.empty()) {
    std::string id = text_behind(format.label, beginning);
    if (!id.empty()) told.push_back(std::move(id));
  }
  std::string name = std::filesystem::path(file).filename().string();
  name.erase(std::min(name.find('.'), name.size()));
  for (const std::string_view prefix : parted(format.prefixes, '|')) {
    if (!prefix.empty() && name.size() > prefix.size() &&
        equal_ignoring_case(std::string_view(name).substr(0, prefix.size()), prefix))
      told.push_back(name.substr(prefix.size()));
  }
  return told;
}

}  // namespace thiessen
