#include "text/csv_reader.h"

#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

/// Counts line ends as an editor does: LF, CRLF and CR each end one line.
std::size_t count_line_ends(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool inside_crlf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if ((text[i] == '\n' || text[i] == '\r') && !inside_crlf) ++count;
  }
  return count;
}

/// Replaces each pair of quotes by one quote, in place. Returns the new end.
char* halve_quotes(char* begin, const char* end) {
  char* to = begin;
  for (const char* from = begin; from < end; ++from) {
    *to++ = *from;
    if (*from == '"') ++from;
  }
  return to;
}

/// The separator with which a header of one name seems to be written, or '\0'.
char likely_separator(std::string_view name, char used) {
  for (const char candidate : {',', ';', '\t', '|'}) {
    if (candidate != used && name.find(candidate) != std::string_view::npos) return candidate;
  }
  return '\0';
}

}  // namespace

CsvReader::CsvReader(const std::string& file, CsvOptions options)
    : CsvReader(InputFile(file), std::move(options), file != "-") {}

CsvReader::CsvReader(InputFile input, CsvOptions options)
    : CsvReader(std::move(input), std::move(options), false) {}

CsvReader::CsvReader(InputFile input, CsvOptions options, bool is_on_disk)
    : options_(options),
      said_(std::move(options)),
      is_on_disk_(is_on_disk),
      text_(std::move(input), options_.separator, options_.encoding) {
  skip_byte_order_mark();
  if (options_.finds_form || options_.separator == '\0') find_form();
  read_header();
  if (options_.has_names) check_header();
  pass_rows_below_header();
}

bool CsvReader::next(Row& row) {
  static_assert(csv_block >= number_padding);
  if (has_first_row_) return next_of_first(row);
  row.padded = true;
  row.fields.resize(header_.size());
  for (;;) {
    const RowKind kind = read_row(row.fields);
    if (kind == RowKind::none) {
      complaints_.throw_if_any();
      return false;
    }
    if (kind == RowKind::bad || !is_row(row)) continue;
    row.line = row_line_;
    return true;
  }
}

/// Whether what was read is a row of the table: not where it has other fields than the header,
/// which is a fault, nor where it has no value at all, as spreadsheets leave such rows behind.
bool CsvReader::is_row(const Row& row) {
  if (options_.finds_form && header_.size() > 1 && beyond_ == 0) {
    const auto kept = std::span(row.fields).first(std::min(field_count_, header_.size()));
    if (field_count_ > 1 && std::ranges::all_of(kept, &std::string_view::empty)) return false;
  }
  const std::size_t columns = header_.size() + form_.columns_passed;
  if (beyond_ > 0 && field_count_ == columns) {
    complaints_.add({file(), row_line_,
                     "a value stands in column " + std::to_string(beyond_) +
                         ", which has no name and no values in the rows above",
                     "give the column a name"});
    return false;
  }
  if (field_count_ == columns || field_count_ == header_.size()) return true;
  complaints_.add(
      {file(), row_line_,
       "row has " + counted(field_count_, "field") + ", the header has " + std::to_string(columns),
       ""});
  return false;
}

bool CsvReader::next_of_first(Row& row) {
  has_first_row_ = false;
  row.padded = false;
  row.line = header_line_;
  row.fields.assign(first_row_.begin(), first_row_.end());
  return true;
}

double CsvReader::share_read() const {
  const std::size_t size = text_.size();
  if (size == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(std::min(next_row_, size)) / static_cast<double>(size);
}

std::unique_ptr<Table> CsvReader::again() const {
  struct stat status = {};
  if (!is_on_disk_ || ::stat(file().c_str(), &status) != 0) return nullptr;
  if (!S_ISREG(status.st_mode)) return nullptr;
  return std::make_unique<CsvReader>(file(), said_);
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
  options_.separator = form_.separator;
  text_.set_separator(form_.separator);
  trims_ = options_.finds_form && form_.has_blanks;
  if (!is_on_disk_ && !text_.may_wait())
    beginning_ = text_.between(begin, std::min(text_.end(), begin + csv_beginning_bytes));
  if (!options_.finds_form) return;
  next_row_ = begin + form_.header;
  line_ += count_line_ends(text_.between(begin, next_row_));
}

/// Reads the beginning, and finds out what it tells. A pipe may bring no more than one row for
/// long, so that the first tells all, however much comes at once.
void CsvReader::look_at_beginning(std::size_t begin) {
  CsvHints hints{options_.separator,
                 options_.decimal_comma,
                 options_.skip,
                 options_.has_names && options_.finds_form && options_.numbers.empty(),
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
         skips ? setting("skip") + " is of all CSV files, " + setting("stations_skip") +
                     " and the like of one"
               : Wording());
  }
  header_line_ = row_line_;
  header_.assign(names.begin(), names.end());
  if (options_.finds_form) pass_columns();
  if (!options_.numbers.empty()) number_columns();
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
  first_row_ = std::exchange(header_, {});
  has_first_row_ = true;
  for (std::size_t i = 1; i <= first_row_.size(); ++i) header_.push_back(std::to_string(i));
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
    if (header_[i].empty()) continue;
    const auto [first, fresh] = columns.emplace(header_[i], i);
    if (fresh) continue;
    twice.add({file(), header_line_,
               "the header has " + quoted(header_[i]) + " twice, in columns " +
                   std::to_string(first->second + 1) + " and " + std::to_string(i + 1),
               ""});
  }
  twice.throw_if_any();
}

void CsvReader::begin_row(std::size_t at) {
  row_ = field_ = at;
  row_line_ = line_;
  field_count_ = 0;
  beyond_ = 0;
}

CsvReader::RowKind CsvReader::read_row(std::vector<std::string_view>& fields) {
  fields_ = &fields;
  begin_row(next_row_);
  for (;;) {
    const std::size_t at = text_.next_mark();
    if (at == text_.end()) {
      if (!read_more()) return end_last_row();
      text_.seek(at);
      continue;
    }
    const char mark = text_.at(at);
    if (mark == options_.separator) {
      if (mark != ' ' || at != field_) store(text_.between(field_, at), false);
      field_ = at + 1;
    } else if (mark != '"') {
      const bool blank = is_blank_line(at);
      if (!blank && !is_after_blank(at)) store(text_.between(field_, at), false);
      const RowKind kind = end_row(at);
      if (!blank) return kind;
      begin_row(next_row_);
    } else if (at != field_) {
      return skip_rest_of_line(at + 1, "a quote stands inside field", field_count_ + 1);
    } else {
      const Follows follows = read_quoted_field();
      if (follows == Follows::nothing) return RowKind::whole;
      if (follows == Follows::line_end) return end_row(field_);
      if (follows == Follows::text) {
        return skip_rest_of_line(field_, "text follows the closing quote of field", field_count_);
      }
      text_.seek(++field_);
    }
  }
}

void CsvReader::store_beyond(std::string_view field, bool in_quotes) {
  if (header_line_ == 0) {
    if (field_count_ == options_.limits.columns) {
      fail(line_, "has more than " + counted(options_.limits.columns, "column") + ", the limit");
    }
    fields_->push_back(in_quotes ? field : trimmed(field));
  }
  ++field_count_;
  if (beyond_ > 0 || header_line_ == 0 || field.empty()) return;
  if (field_count_ > header_.size() && !equal_ignoring_case(field, known::end_of_record))
    beyond_ = field_count_;
}

/// Whether the field that ends here is nothing but a blank at the end of the line, which parts
/// nothing.
bool CsvReader::is_after_blank(std::size_t end) const {
  return options_.separator == ' ' && field_ == end && field_count_ > 0;
}

CsvReader::RowKind CsvReader::end_row(std::size_t at) {
  next_row_ = at + 1;
  if (text_.at(at) == '\r') {
    const bool more = next_row_ < text_.end() || read_more();
    if (more && text_.at(next_row_) == '\n') ++next_row_;
    text_.seek(next_row_);
  } else if (field_ == at) {
    text_.seek(next_row_);  // after a quoted field, or an empty one
  }
  ++line_;  // only now: what read_more refuses counts the line ends from the field's beginning
  check_lengths(at);
  return RowKind::whole;
}

CsvReader::RowKind CsvReader::end_last_row() {
  const std::size_t end = next_row_ = text_.end();
  if (is_blank_line(end)) return RowKind::none;
  if (!is_after_blank(end)) store(text_.between(field_, end), false);
  check_lengths(end);
  return RowKind::whole;
}

bool CsvReader::is_blank_line(std::size_t end) const {
  return field_count_ == 0 && trimmed(text_.between(row_, end)).empty();
}

CsvReader::RowKind CsvReader::skip_rest_of_line(std::size_t from, const std::string& fault,
                                                std::size_t column) {
  complaints_.add({file(), line_, fault + " " + std::to_string(column),
                   "a quote within a quoted field is written twice"});
  text_.seek(from);
  for (;;) {
    const std::size_t at = text_.next_mark();
    if (at == text_.end()) {
      if (!read_more()) break;
      text_.seek(at);
    } else if (text_.at(at) == '\n' || text_.at(at) == '\r') {
      end_row(at);
      return RowKind::bad;
    }
  }
  next_row_ = text_.end();
  return RowKind::bad;
}

CsvReader::Follows CsvReader::read_quoted_field() {
  std::size_t doubled = 0;
  const std::size_t closing = find_closing_quote(doubled);
  const std::size_t begin = field_ + 1;
  std::size_t end = closing;
  line_ += count_line_ends(text_.between(begin, end));
  if (doubled > 0) {
    halve_quotes(text_.pointer(begin), text_.pointer(end));
    end -= doubled;
  }
  store(text_.between(begin, end), true);
  field_ = closing + 1;
  if (field_ == text_.end()) {
    text_.seek(next_row_ = field_);
    return Follows::nothing;
  }
  const char next = text_.at(field_);
  if (next == options_.separator) return Follows::separator;
  return next == '\n' || next == '\r' ? Follows::line_end : Follows::text;
}

std::size_t CsvReader::find_closing_quote(std::size_t& doubled) {
  for (std::size_t from = field_ + 1;;) {
    const std::size_t found = text_.between(from, text_.end()).find('"');
    if (found == std::string_view::npos) {
      from = text_.end();
      if (!read_more(true)) fail(line_, "the quote that opens here is never closed");
      continue;
    }
    from += found + 1;
    if (from == text_.end() && !read_more(true)) return from - 1;
    if (text_.at(from) != '"') return from - 1;
    ++doubled;
    ++from;
  }
}

bool CsvReader::read_more(bool in_quotes) {
  check_limits(in_quotes);
  const auto before = reinterpret_cast<std::uintptr_t>(text_.pointer(row_));
  const CsvText::Arrival arrival = text_.read_more(row_);
  keep_views(before);
  if (arrival != CsvText::Arrival::more && arrival != CsvText::Arrival::end) refuse_bytes(arrival);
  return arrival == CsvText::Arrival::more;
}

void CsvReader::keep_views(std::uintptr_t before) {
  const char* const now = text_.pointer(row_);
  if (reinterpret_cast<std::uintptr_t>(now) == before || fields_ == nullptr) return;
  const std::size_t kept = std::min(field_count_, fields_->size());
  for (std::string_view& field : std::span(*fields_).first(kept)) {
    field = {now + (reinterpret_cast<std::uintptr_t>(field.data()) - before), field.size()};
  }
}

void CsvReader::check_limits(bool in_quotes) {
  const std::size_t longest = options_.limits.field_bytes;
  if (text_.end() - field_ > longest + 2) {
    if (in_quotes) {
      fail(line_, "the quote that opens here is not closed within " + counted(longest, "byte") +
                      ", the limit for a field");
    }
    fail(line_, "field " + std::to_string(field_count_ + 1) + " is longer than " +
                    counted(longest, "byte") + ", the limit");
  }
  check_lengths(text_.end());
}

void CsvReader::check_lengths(std::size_t end) {
  const CsvLimits& limits = options_.limits;
  if (end - row_ > limits.row_bytes) {
    fail(row_line_, "the row is longer than " + counted(limits.row_bytes, "byte") + ", the limit");
  }
  if (end - row_ <= limits.field_bytes || fields_ == nullptr) return;
  const std::size_t kept = std::min(field_count_, fields_->size());
  for (std::size_t i = 0; i < kept; ++i) {
    if ((*fields_)[i].size() <= limits.field_bytes) continue;
    fail(row_line_, "field " + std::to_string(i + 1) + " is longer than " +
                        counted(limits.field_bytes, "byte") + ", the limit");
  }
}

void CsvReader::refuse_bytes(CsvText::Arrival arrival) {
  const std::size_t fault = text_.fault();
  if (arrival == CsvText::Arrival::not_decoded) {
    fail(line_ + count_line_ends(text_.between(field_, text_.end())),
         "not " + text_.encoding() + " at byte " + std::to_string(fault),
         setting("encoding") + " names what it is");
  }
  const std::size_t line = line_ + count_line_ends(text_.between(field_, fault));
  const std::string place = " at byte " + std::to_string(fault);
  if (arrival == CsvText::Arrival::nul)
    fail(line, "not text: NUL" + place, "is this a text file in UTF-8?");
  const Wording named = setting("encoding") + " names what it is, such as Latin-1 or cp932";
  fail(line, "not UTF-8" + place, options_.finds_form ? named : "save the file as UTF-8");
}

void CsvReader::fail(std::size_t line, std::string text, Wording hint) {
  complaints_.fail({file(), line, std::move(text), std::move(hint)});
}

}  // namespace thiessen
