#include <algorithm>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/utf8.h"
#include "base/wording.h"
#include "text/csv_dialect.h"
#include "text/csv_reader.h"
#include "text/csv_records.h"

// How a CSV reader begins: what the first bytes tell of how the file is written, its header, and
// the rows below that are none of the table.

namespace thiessen {
namespace {

std::string fields_counted(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " field" : " fields");
}

/// The separator with which a header of one name seems to be written, or '\0'.
char likely_separator(std::string_view name, char used) {
  for (const char candidate : {',', ';', '\t', '|'}) {
    if (candidate != used && name.find(candidate) != std::string_view::npos) return candidate;
  }
  return '\0';
}

/// Whether a text is JSON, of which a pipe does not tell by its name: an object with a first key.
bool is_json(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  if (!text.starts_with('{')) return false;
  text.remove_prefix(std::min(text.find_first_not_of(blanks, 1), text.size()));
  return text.starts_with('"');
}

}  // namespace

void CsvReader::skip_byte_order_mark() {
  const auto has_mark = [&](std::size_t at) {
    while (text_.end() < at + byte_order_mark.size() && read_more()) {
    }
    return text_.between(at, text_.end()).starts_with(byte_order_mark);
  };
  if (!has_mark(0)) return;
  next_row_ = byte_order_mark.size();
  if (has_mark(next_row_)) fail(1, "begins with two byte order marks");
}

void CsvReader::find_form() {
  const std::size_t begin = next_row_;
  look_at_beginning(begin);
  if (options_.finds_form && is_json(text_.between(begin, text_.end())))
    fail(0, "is JSON, and no table",
         "GeoJSON is read from a file on the disk: save it as .geojson");
  options_.separator = form_.separator;
  text_.set_separator(form_.separator);
  trims_ = options_.finds_form && form_.has_blanks;
  if (!is_on_disk_ && !text_.may_wait())
    beginning_ = text_.between(begin, std::min(text_.end(), begin + csv_beginning_bytes));
  if (!options_.finds_form) return;
  if (text_.may_wait()) keep_row_seen(begin);
  next_row_ = begin + form_.header;
  line_ += count_line_ends(text_.between(begin, next_row_));
}

/// Keeps the first row of data of a pipe, which is the last that has to have come.
void CsvReader::keep_row_seen(std::size_t begin) {
  const auto records = csv_records(text_.between(begin, text_.end()), form_.header, false);
  const bool has_names = options_.numbers.empty() && options_.names.empty();
  const std::size_t row = form_.rows_passed + (has_names ? 1 : 0);
  if (row >= records.size()) return;
  for (const std::string_view field : csv_fields(records[row], form_.separator))
    row_seen_.emplace_back(field);
  if (row_seen_.size() != csv_fields(records.front(), form_.separator).size()) row_seen_.clear();
}

/// Reads the beginning, and finds out what it tells. A pipe may bring no more than one row for
/// long, so that the first tells all, however much comes at once.
void CsvReader::look_at_beginning(std::size_t begin) {
  CsvHints hints{options_.separator,
                 options_.decimal_comma,
                 options_.skip,
                 options_.has_names && options_.finds_form && options_.numbers.empty() &&
                     options_.names.empty(),
                 false,
                 text_.may_wait()};
  const std::size_t enough = begin + csv_beginning_bytes;
  const auto look = [&] {
    form_ = find_csv_form(text_.between(begin, std::min(text_.end(), enough)), hints);
  };
  while (text_.end() < enough) {
    if (hints.one_row) look();
    if (hints.one_row && form_.has_rows) return;
    const CsvText::Arrival arrival = text_.read_more(0);
    if (arrival == CsvText::Arrival::end) {
      hints.is_all = true;
      break;
    }
    if (arrival != CsvText::Arrival::more) refuse_bytes(arrival);
  }
  look();
}

void CsvReader::read_header() {
  std::vector<std::string_view> names;
  text_.seek(next_row_);
  const RowKind kind = read_row(names);
  complaints_.throw_if_any();
  if (kind == RowKind::none) {
    const bool skips = options_.skip.value_or(0) > 0;
    fail(0, skips ? "has nothing behind the lines that are skipped" : "is empty",
         skips && options_.skip_is_of_all ? hint_of_skip() : Wording());
  }
  header_line_ = row_line_;
  header_.assign(names.begin(), names.end());
  if (options_.finds_form) pass_columns();
  if (!options_.numbers.empty()) number_columns();
  if (!options_.names.empty()) take_first_row(options_.names);
}

/// Calls the columns by their numbers where the first row does not name all columns that are meant.
/// Where it has each number in the column of that number it is taken for data, such as 1,2,3.
void CsvReader::number_columns() {
  bool are_names = true;
  bool are_in_place = true;
  for (const std::string& number : options_.numbers) {
    const auto found = std::ranges::find(header_, number);
    are_names = are_names && found != header_.end();
    are_in_place = are_in_place && std::to_string(found - header_.begin() + 1) == number;
  }
  if (are_names && !are_in_place) return;
  std::vector<std::string> numbers;
  for (std::size_t i = 1; i <= header_.size(); ++i) numbers.push_back(std::to_string(i));
  take_first_row(std::move(numbers));
}

/// Takes what was read as the header for the first row below these names.
void CsvReader::take_first_row(std::vector<std::string> names) {
  if (header_.size() != names.size()) {
    fail(header_line_,
         "row has " + fields_counted(header_.size()) + ", and not " + std::to_string(names.size()));
  }
  first_row_ = std::exchange(header_, std::move(names));
  has_first_row_ = true;
}

void CsvReader::pass_columns() {
  form_.columns_passed = std::min(form_.columns_passed, header_.size() - 1);
  header_.resize(header_.size() - form_.columns_passed);
}

void CsvReader::pass_rows_below_header() {
  if (!options_.finds_form) return;
  std::vector<std::string_view> fields(header_.size());
  for (std::size_t i = 0; i < form_.rows_passed; ++i) read_row(fields);
}

void CsvReader::check_header() const {
  if (header_.size() == 1) {
    const char other = likely_separator(header_[0], options_.separator);
    if (other != '\0') {
      throw Error({file(), header_line_, "the header is one field, " + quoted(header_[0], 80),
                   "without " + setting("separator") +
                       " each file's own is found out: comma, semicolon, tab or bar"});
    }
  }
  Complaints twice;
  std::unordered_map<std::string_view, std::size_t> columns;
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (header_[i].empty() || std::ranges::count(options_.repeated, header_[i]) > 0) continue;
    const auto [first, fresh] = columns.emplace(header_[i], i);
    if (fresh) continue;
    twice.add({file(), header_line_,
               "the header has " + quoted(header_[i]) + " twice, in columns " +
                   std::to_string(first->second + 1) + " and " + std::to_string(i + 1),
               ""});
  }
  twice.throw_if_any();
}

bool CsvReader::next_of_first(Row& row) {
  has_first_row_ = false;
  row.padded = false;
  row.line = header_line_;
  row.fields.assign(first_row_.begin(), first_row_.end());
  return true;
}

std::unique_ptr<Table> CsvReader::first_rows() const {
  if (auto table = again()) return table;
  if (beginning_.empty()) return nullptr;
  InputFile input(file(), [text = beginning_, at = std::size_t{0}](std::span<char> into) mutable {
    const std::size_t count = text.copy(into.data(), into.size(), at);
    at += count;
    return count;
  });
  CsvOptions options = said_;
  options.encoding = "UTF-8";
  return std::make_unique<CsvReader>(std::move(input), std::move(options));
}

}  // namespace thiessen
