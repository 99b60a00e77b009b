#include "readings/readings_grammar.h"

#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr Reading gap = {};
constexpr Reading trace_of_rain = {0, ReadingKind::amount};

Reading fault(ReadingKind kind) {
  Reading reading;
  reading.kind = kind;
  return reading;
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

bool ReadingGrammar::wants_decimal_comma(std::string_view text) const {
  return mark_ == DecimalMark::point && parse_number(trimmed(text), DecimalMark::comma);
}

}  // namespace thiessen
