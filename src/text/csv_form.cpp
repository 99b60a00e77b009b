#include "text/csv_form.h"

#include <algorithm>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/utf8.h"
#include "text/csv_records.h"
#include "text/field_names.h"
#include "text/known_names.h"
#include "text/unit_row.h"

namespace thiessen {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::string_view separators = ",;\t|";
constexpr std::size_t rows_compared = 20;

bool is_known_name(std::string_view name) {
  static const std::unordered_set<std::string> names = [] {
    std::unordered_set<std::string> all;
    const auto enter = [&](const auto& some) {
      for (const std::string_view one : some) all.insert(plain_name(one));
    };
    enter(known::times);
    enter(known::years);
    enter(known::station_ids);
    enter(known::eastings);
    enter(known::northings);
    enter(known::values);
    enter(known::geometries);
    return all;
  }();
  return !name.empty() && names.contains(plain_name(name));
}

bool has_known_name(const Fields& fields) {
  return std::ranges::any_of(fields, is_known_name);
}

/// The same where a unit in brackets may stand behind a name: rain (mm).
bool has_known_name_or_unit(const Fields& fields) {
  return has_known_name(fields) || std::ranges::any_of(fields, [](std::string_view field) {
           return field.ends_with(')') && is_known_name(field.substr(0, field.find('(')));
         });
}

/// Whether a row has so many fields, or beyond them empty ones alone.
bool has_as_many(const Fields& row, std::size_t fields) {
  return row.size() >= fields &&
         std::all_of(row.begin() + static_cast<std::ptrdiff_t>(fields), row.end(),
                     [](std::string_view field) { return field.empty(); });
}

bool has_number(const Fields& fields) {
  return std::ranges::any_of(fields, [](std::string_view field) {
    return parse_number(field) || parse_number(field, DecimalMark::comma);
  });
}

/// Finds the form of one beginning.
class FormFinder {
 public:
  FormFinder(std::string_view beginning, const CsvHints& hints)
      : beginning_(beginning), hints_(hints) {}

  CsvForm find() {
    pass_remarks();
    records_ = csv_records(beginning_, form_.header, hints_.is_all);
    if (records_.empty()) return form_;
    form_.header = records_[0].at;
    if (hints_.has_names) find_header();
    form_.separator = separator_of(header_);
    if (hints_.has_names) find_rows_passed();
    find_rows();
    if (hints_.has_names) find_columns_passed();
    find_mark();
    find_blanks();
    keep_lines_above();
    return form_;
  }

 private:
  /// Passes the lines that are skipped, one that names the separator, and remarks.
  void pass_remarks() {
    std::size_t at = 0;
    for (std::size_t i = 0; i < hints_.skip.value_or(0); ++i) at = next_line(at);
    std::optional<std::size_t> remark;
    for (bool first = true; at < beginning_.size(); first = false) {
      const std::string_view line = trimmed(line_at(at));
      if (first && names_separator(line)) {
        said_ = line[4];
      } else if (line.starts_with('#')) {
        remark = at;
      } else if (!line.empty()) {
        break;
      }
      at = next_line(at);
    }
    form_.header = at;
    if (remark && hints_.has_names && is_header_of(*remark, at)) form_.header = within(*remark);
  }

  /// Keeps what may say what is in the table: lines of a usual length.
  void keep_lines_above() {
    constexpr std::size_t longest = 200;
    constexpr std::size_t most = 100;
    for (std::size_t at = 0; at < form_.header; at = next_line(at)) {
      const std::string_view line = trimmed(line_at(at));
      if (line.empty() || line.size() > longest) continue;
      if (form_.lines_above.size() == most) form_.lines_above.erase(form_.lines_above.begin());
      form_.lines_above.emplace_back(line);
    }
  }

  static bool names_separator(std::string_view line) {
    return line.size() == 5 && equal_ignoring_case(line.substr(0, 4), "sep=") && line[4] != '"';
  }

  std::string_view line_at(std::size_t at) const {
    const std::size_t end = std::min(beginning_.find_first_of("\r\n", at), beginning_.size());
    return beginning_.substr(at, end - at);
  }

  std::size_t next_line(std::size_t at) const {
    at += line_at(at).size();
    if (beginning_.substr(at).starts_with("\r\n")) return at + 2;
    return std::min(at + 1, beginning_.size());
  }

  /// Where what stands in a remark begins.
  std::size_t within(std::size_t remark) const {
    return std::min(beginning_.find_first_not_of("# \t", remark), beginning_.size());
  }

  /// Whether a remark holds the names of the row below it.
  bool is_header_of(std::size_t remark, std::size_t row) {
    const std::size_t names = within(remark);
    records_ = csv_records(beginning_.substr(0, next_line(row)), names, true);
    if (records_.size() < 2) return false;
    const char separator = separator_of(0);
    const Fields fields = csv_fields(records_[0], separator);
    const Fields below = csv_fields(records_[1], separator);
    return fields.size() >= 2 && fields.size() == below.size() && has_known_name(fields) &&
           !has_known_name(below);
  }

  /// What parts the fields of a record that is a header, by the records below it.
  char separator_of(std::size_t record) const {
    if (hints_.separator != '\0') return hints_.separator;
    if (said_) return *said_;
    char found = ',';
    std::size_t most = 0;
    bool fits = false;
    for (const char candidate : separators) {
      const std::size_t fields = csv_fields(records_[record], candidate).size();
      if (fields < 2) continue;
      const bool fits_below = is_below(record, candidate, fields, 1);
      if (most > 0 && (fits_below < fits || (fits_below == fits && fields <= most))) continue;
      found = candidate;
      most = fields;
      fits = fits_below;
    }
    if (most == 0 && is_parted_by_blanks(record)) return ' ';
    return found;
  }

  bool is_parted_by_blanks(std::size_t record) const {
    const Fields words = csv_fields(records_[record], ' ');
    return words.size() >= 2 && has_known_name(words) &&
           is_below(record, ' ', words.size(), rows_compared);
  }

  /// Whether the records below have so many fields: all of them, and at least one.
  bool is_below(std::size_t record, char separator, std::size_t fields, std::size_t records) const {
    std::size_t seen = 0;
    if (hints_.one_row) records = 1;
    for (std::size_t i = record + 1; i < records_.size() && seen < records; ++i, ++seen) {
      if (!records_[i].whole) break;
      if (!has_as_many(csv_fields(records_[i], separator), fields)) return false;
    }
    return seen > 0;
  }

  /// Looks for a header below a preamble where the first record does not look like one. Where it
  /// has as many fields as the record below it, as labels and their texts have, too, only one with
  /// more of them, parted alike, is the header.
  void find_header() {
    if (hints_.skip) return;
    const char separator = separator_of(0);
    const Fields first = csv_fields(records_[0], separator);
    if (has_known_name(first)) return;
    const bool may_be_header =
        first.size() > 1 && (records_.size() == 1 || is_below(0, separator, first.size(), 1));
    if (may_be_header && hints_.one_row) return;
    const std::size_t surpassed = may_be_header ? first.size() : 0;
    std::size_t best = 0;
    for (std::size_t i = 1; i < records_.size(); ++i) {
      const std::size_t size = size_below(i, surpassed);
      if (size <= best || (may_be_header && separator_of(i) != separator)) continue;
      best = size;
      header_ = i;
      if (hints_.one_row) break;
    }
    is_sure_ = may_be_header || header_ > 0;
    if (header_ == 0) return;
    for (std::size_t at = form_.header; at < records_[header_].at; at = next_line(at))
      ++form_.preamble;
    form_.header = records_[header_].at;
  }

  /// How many fields stand in a record and those below it that have as many; 0 where the record
  /// does not look like a header, or has no more fields than those to be surpassed.
  std::size_t size_below(std::size_t record, std::size_t surpassed) const {
    const char separator = separator_of(record);
    const Fields fields = csv_fields(records_[record], separator);
    if (fields.size() < 2 || fields.size() <= surpassed) return 0;
    if (!has_known_name_or_unit(fields) || has_number(fields)) return 0;
    std::size_t records = 1;
    while (record + records < records_.size() &&
           has_as_many(csv_fields(records_[record + records], separator), fields.size()))
      ++records;
    const bool is_last = !hints_.one_row && record + 1 == records_.size();
    return records > 1 || is_last ? records * fields.size() : 0;
  }

  void find_rows_passed() {
    std::size_t row = header_ + 1;
    const auto passes = [&](const auto& is_one) {
      if (row >= records_.size() || !records_[row].whole) return;
      if (!is_one(csv_fields(records_[row], form_.separator))) return;
      ++form_.rows_passed;
      ++row;
    };
    passes(is_row_of_formats);
    passes([&](const Fields& fields) { return is_row_of_units(fields); });
  }

  /// Whether these are formats of USGS's tables: 5s, 20d, 14n.
  static bool is_row_of_formats(const Fields& fields) {
    return fields.size() >= 2 && std::ranges::all_of(fields, [](std::string_view field) {
             return field.size() >= 2 &&
                    std::string_view("sdn").find(field.back()) != std::string_view::npos &&
                    field.find_first_not_of("0123456789") == field.size() - 1;
           });
  }

  bool is_row_of_units(const Fields& fields) {
    auto row = unit_row(fields);
    if (!row) return false;
    form_.units = std::move(row->units);
    form_.column_units = std::move(row->of_column);
    return true;
  }

  /// Splits the rows below the header.
  void find_rows() {
    const std::size_t first = header_ + form_.rows_passed + (hints_.has_names ? 1 : 0);
    form_.has_rows = is_sure_ && first < records_.size() && records_[first].whole;
    for (std::size_t i = first; i < records_.size(); ++i) {
      rows_.push_back(csv_fields(records_[i], form_.separator));
      if (hints_.one_row) break;
    }
  }

  /// Counts the columns at the end that have no name, or are called the end of the record, and
  /// hold nothing else.
  void find_columns_passed() {
    if (form_.separator == ' ') return;
    const Fields names = csv_fields(records_[header_], form_.separator);
    const auto is_end = [](std::string_view text) {
      return text.empty() || equal_ignoring_case(text, known::end_of_record);
    };
    std::size_t kept = names.size();
    while (kept > 1 && is_end(names[kept - 1]) &&
           std::ranges::all_of(rows_, [&](const Fields& row) {
             return row.size() < kept || is_end(row[kept - 1]);
           }))
      --kept;
    form_.columns_passed = names.size() - kept;
  }

  void find_mark() {
    bool comma = hints_.decimal_comma;
    bool point = false;
    for (const Fields& row : rows_) {
      if (hints_.decimal_comma) break;
      for (const std::string_view field : row) {
        if (field.find(',') != std::string_view::npos) {
          comma = comma || (parse_number(field, DecimalMark::comma) && !may_part_thousands(field));
        } else if (field.find('.') != std::string_view::npos) {
          point = point || parse_number(field);
        }
      }
    }
    if (comma && !point) form_.mark = DecimalMark::comma;
  }

  void find_blanks() {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    const auto is_end = [&](char c) { return c == form_.separator || c == '\n' || c == '\r'; };
    const std::string_view text = beginning_.substr(form_.header);
    for (std::size_t i = 0; i + 1 < text.size() && !form_.has_blanks; ++i) {
      form_.has_blanks =
          (is_blank(text[i]) && is_end(text[i + 1])) || (is_end(text[i]) && is_blank(text[i + 1]));
    }
    form_.has_blanks = form_.has_blanks || hints_.one_row;
  }

  std::string_view beginning_;
  const CsvHints& hints_;
  CsvForm form_;
  std::vector<CsvRecord> records_;
  std::vector<Fields> rows_;
  std::optional<char> said_;
  std::size_t header_ = 0;  ///< which of the records
  bool is_sure_ = true;     ///< false: no header was found, and more may tell
};

}  // namespace

CsvForm find_csv_form(std::string_view beginning, const CsvHints& hints) {
  return FormFinder(beginning, hints).find();
}

}  // namespace thiessen
