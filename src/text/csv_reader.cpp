#include "text/csv_reader.h"

#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

#include "base/counted.h"
#include "base/number.h"
#include "base/utf8.h"
#include "text/csv_records.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

/// Replaces each pair of quotes by one quote, in place. Returns the new end.
char* halve_quotes(char* begin, const char* end) {
  char* to = begin;
  for (const char* from = begin; from < end; ++from) {
    *to++ = *from;
    if (*from == '"') ++from;
  }
  return to;
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
  if (std::exchange(has_ahead_, false)) {
    std::swap(row, ahead_);
    return true;
  }
  for (;;) {
    if (!complaints_.empty() && waits(patience_.left())) complaints_.throw_if_any();
    const Reached reached = read_next(row);
    if (reached != Reached::no_row) return reached == Reached::row;
  }
}

/// Reads what comes next, which may be no row of the table.
CsvReader::Reached CsvReader::read_next(Row& row) {
  row.padded = true;
  row.fields.resize(header_.size());
  const RowKind kind = read_row(row.fields);
  if (kind == RowKind::none) {
    complaints_.throw_if_any();
    return Reached::end;
  }
  if (kind == RowKind::bad || !is_row(row)) return Reached::no_row;
  if (!complaints_.empty() && text_.may_wait()) return Reached::no_row;
  row.line = row_line_;
  return Reached::row;
}

/// Where a row has a fault, `next` knows how long to wait for others.
bool CsvReader::is_waiting(std::chrono::milliseconds patience) {
  return waits(patience) && complaints_.empty();
}

bool CsvReader::waits(std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  if (!text_.may_wait() || has_first_row_ || has_ahead_) return false;
  std::optional<Clock::time_point> until;
  for (;;) {
    while (!has_line()) {
      if (!until) until = Clock::now() + patience;
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(*until - Clock::now());
      if (!text_.has_bytes(std::max(left, std::chrono::milliseconds(0)))) return true;
      if (text_.is_at_end()) return false;
      look_for_more();
    }
    const Reached reached = read_next(ahead_);
    has_ahead_ = reached == Reached::row;
    if (reached != Reached::no_row) return false;
  }
}

/// Whether a line that is not blank lies in the window, from the next row on, with its end. One
/// that is longer than a field may be counts, for reading it says what is wrong.
bool CsvReader::has_line() {
  blank_to_ = std::max(blank_to_, next_row_);
  for (;;) {
    searched_to_ = std::max(searched_to_, blank_to_);
    const std::string_view rest = text_.between(searched_to_, text_.end());
    std::size_t length = rest.find('\n');
    if (length == std::string_view::npos) length = rest.find('\r');
    searched_to_ += std::min(length, rest.size());
    if (length == std::string_view::npos)
      return text_.end() - blank_to_ > options_.limits.field_bytes;
    if (text_.between(blank_to_, searched_to_).find_first_not_of(" \t\r") != std::string_view::npos)
      return true;
    blank_to_ = searched_to_ + 1;
  }
}

/// Reads more of the file behind what has come of the next row.
void CsvReader::look_for_more() {
  begin_row(next_row_);
  const CsvText::Arrival arrival = text_.read_more(row_);
  text_.seek(row_);
  if (arrival != CsvText::Arrival::more && arrival != CsvText::Arrival::end) refuse_bytes(arrival);
}

/// Passes over the LF of a CRLF whose CR ended the row before.
void CsvReader::pass_line_feed() {
  after_return_ = false;
  begin_row(next_row_);
  const bool more = next_row_ < text_.end() || read_more();
  if (more && text_.at(next_row_) == '\n') ++next_row_;
  text_.seek(next_row_);
}

/// Whether what was read is a row of the table: not where it has other fields than the header,
/// which is a fault, nor where it has no value at all, as spreadsheets leave such rows behind. They
/// leave empty fields behind a row's last value, too, which are none.
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
  const bool ends_in_blanks = options_.finds_form && field_count_ > columns && beyond_ == 0;
  if (field_count_ == columns || field_count_ == header_.size() || ends_in_blanks) return true;
  complaints_.add(
      {file(), row_line_,
       "row has " + counted(field_count_, "field") + ", the header has " + std::to_string(columns),
       ""});
  return false;
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

void CsvReader::begin_row(std::size_t at) {
  row_ = field_ = at;
  row_line_ = line_;
  field_count_ = 0;
  beyond_ = 0;
}

CsvReader::RowKind CsvReader::read_row(std::vector<std::string_view>& fields) {
  fields_ = &fields;
  if (after_return_) pass_line_feed();
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
      if (after_return_) pass_line_feed();
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
  if (text_.at(at) == '\r' && next_row_ == text_.end() && text_.may_wait()) {
    after_return_ = true;  // whether a LF follows is not waited for
    text_.seek(next_row_);
  } else if (text_.at(at) == '\r') {
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
         setting(setting_for(options_.input, "encoding")) + " names what it is");
  }
  const std::size_t line = line_ + count_line_ends(text_.between(field_, fault));
  const std::string place = " at byte " + std::to_string(fault);
  if (arrival == CsvText::Arrival::nul)
    fail(line, "not text: NUL" + place, "is this a text file in UTF-8?");
  const Wording named = setting(setting_for(options_.input, "encoding")) +
                        " names what it is, such as Latin-1 or cp932";
  fail(line, "not UTF-8" + place, options_.finds_form ? named : "save the file as UTF-8");
}

void CsvReader::fail(std::size_t line, std::string text, Wording hint) {
  complaints_.fail({file(), line, std::move(text), std::move(hint)});
}

}  // namespace thiessen
