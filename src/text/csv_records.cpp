#include "text/csv_records.h"

#include <algorithm>

#include "base/utf8.h"

namespace thiessen {
namespace {

std::string_view without_quotes(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = trimmed(field.substr(1, field.size() - 2));
  return field;
}

/// The end of the record that begins at `from`: the first line end outside quotes, else the first.
std::size_t end_of_record(std::string_view text, std::size_t from) {
  bool quoted = false;
  for (std::size_t at = from; at < text.size(); ++at) {
    if (text[at] == '"') quoted = !quoted;
    if (!quoted && (text[at] == '\n' || text[at] == '\r')) return at;
  }
  return quoted ? std::min(text.find_first_of("\r\n", from), text.size()) : text.size();
}

/// A number that has a comma, read with that as its decimal mark, and as none.
std::string with_point(std::string_view number) {
  std::string text(number);
  text[text.find(',')] = '.';
  return text;
}

std::string without_comma(std::string_view number) {
  std::string text(number);
  return text.erase(text.find(','), 1);
}

}  // namespace

std::vector<CsvRecord> csv_records(std::string_view beginning, std::size_t from, bool is_all) {
  std::vector<CsvRecord> records;
  while (from < beginning.size()) {
    const std::size_t end = end_of_record(beginning, from);
    const std::string_view text = beginning.substr(from, end - from);
    const bool whole = end < beginning.size() || is_all;
    if (!trimmed(text).empty()) records.push_back({text, from, whole});
    from = end + 1;
  }
  return records;
}

std::vector<std::string_view> csv_fields(const CsvRecord& record, char separator) {
  std::vector<std::string_view> fields;
  const std::string_view text = separator == ' ' ? trimmed(record.text) : record.text;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= text.size(); ++at) {
    const bool ends = at == text.size();
    if (!ends && text[at] == '"') quoted = !quoted;
    if (!ends && (quoted || text[at] != separator)) continue;
    if (separator != ' ' || at > begin)
      fields.push_back(without_quotes(text.substr(begin, at - begin)));
    begin = at + 1;
  }
  if (!record.whole && !fields.empty()) fields.pop_back();
  return fields;
}

bool may_part_thousands(std::string_view number) {
  if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const std::size_t comma = number.find(',');
  return comma >= 1 && comma <= 3 && number[0] != '0' && number.size() == comma + 4 &&
         std::ranges::all_of(number.substr(0, comma), is_digit) &&
         std::ranges::all_of(number.substr(comma + 1), is_digit);
}

std::string no_number_for_its_comma(std::string_view text) {
  if (!may_part_thousands(text)) return " is no number";
  return " could be " + with_point(text) + " or " + without_comma(text);
}

Wording hint_for_its_comma(std::string_view text, std::string_view input) {
  const Wording comma = setting(setting_for(input, "decimal_comma"));
  if (!may_part_thousands(text)) return comma + " reads 1,5 as 1.5";
  return comma + " reads it as " + with_point(text) + "; where it is " + without_comma(text) +
         ", write it without the comma";
}

Wording hint_for_its_point(std::string_view input, bool commas_are_said) {
  if (!commas_are_said) return "write all numbers of the file with one decimal mark";
  return "without " + setting(setting_for(input, "decimal_comma")) + " or " +
         setting("decimal_comma") + " the decimal mark is found out";
}

std::string setting_for(std::string_view input, std::string_view name) {
  return std::string(input) + (input.empty() ? "" : "_") + std::string(name);
}

}  // namespace thiessen
