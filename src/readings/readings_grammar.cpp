#include "readings/readings_grammar.h"

#include <algorithm>

#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr std::string_view digits = "0123456789";
constexpr Reading gap = {};
constexpr Reading trace_of_rain = {0, ReadingKind::amount};

Reading fault(ReadingKind kind) {
  Reading reading;
  reading.kind = kind;
  return reading;
}

/// Whether a text is made of groups of digits alone: 1,234.5, 1.234,5, 1 234, 1'234.
bool has_thousands(std::string_view text) {
  std::string plain(text);
  for (const std::string_view blank : {"\xC2\xA0", "\xE2\x80\xAF"}) {  // that part no lines
    for (std::size_t at = 0; (at = plain.find(blank, at)) != std::string::npos;)
      plain.replace(at, blank.size(), " ");
  }
  if (plain.find_first_not_of("0123456789,.' ") != std::string::npos) return false;
  const std::size_t mark = plain.find_first_not_of(digits);
  return mark > 0 && mark + 3 < plain.size() &&
         plain.find_first_not_of(digits, mark + 1) != mark + 1 &&
         plain.substr(mark + 1, 3).find_first_not_of(digits) == std::string::npos;
}

/// Whether a text is a word and a whole number behind it, as codes are: M1, Q 12.
bool is_flag(std::string_view text) {
  const std::size_t digit = text.find_first_of(digits);
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == ' ' || c == '_' || c == '-';
  };
  return digit > 0 && std::ranges::all_of(text.substr(0, digit), is_letter) &&
         text.substr(digit).find_first_not_of(digits) == std::string_view::npos;
}

}  // namespace

ReadingGrammar::ReadingGrammar(std::span<const std::string> missing,
                               std::span<const std::string> trace, DecimalMark mark)
    : mark_(mark) {
  for (const std::string& text : missing) add(text, gap);
  for (const std::string& text : trace) add(text, trace_of_rain);
  add("", gap);
  for (const std::string_view text : known::gaps) add(text, gap);
}

void ReadingGrammar::add(std::string_view text, Reading meaning) {
  text = trimmed(text);
  Parsed<double> number = parse_number(text, mark_);
  if (!number) {
    texts_.push_back({std::string(text), meaning});
    number = parse_number(text);  // -99.9 is a number beside decimal commas, too
  }
  if (!number) return;
  numbers_.push_back({number.value, meaning});
  only_negative_ = only_negative_ && number.value < 0;
}

Reading ReadingGrammar::read_special(std::string_view text) const {
  const Parsed<double> number = parse_number(text, mark_);
  if (number) {
    for (const SpecialNumber& special : numbers_) {
      if (special.number == number.value) return special.meaning;
    }
    if (number.value < 0) return fault(ReadingKind::negative);
    return {number.value + 0.0, ReadingKind::amount};
  }
  for (const SpecialText& special : texts_) {
    if (equal_ignoring_case(special.text, text)) return special.meaning;
  }
  const bool too_large = number.fault == NumberFault::out_of_range;
  return fault(too_large ? ReadingKind::out_of_range : ReadingKind::not_a_number);
}

ReadingGrammar::Meant ReadingGrammar::meant_by(std::string_view text) const {
  text = trimmed(text);
  const bool reads_points = mark_ == DecimalMark::point;
  if (parse_number(text, reads_points ? DecimalMark::comma : DecimalMark::point))
    return reads_points ? Meant::decimal_comma : Meant::decimal_point;
  if (text.find_first_of(digits) == std::string_view::npos) return Meant::code;
  // Nearest to 0 a gauge may say no more than that there was less than it measures.
  if (text.starts_with('<')) return Meant::code;
  if (has_thousands(text)) return Meant::thousands;
  return is_flag(text) ? Meant::code : Meant::more;
}

}  // namespace thiessen
